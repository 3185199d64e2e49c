// The result of a turn as plain data: Table 1, axis, closure, poses, template. What turns.json,
// turns.csv and the report show, in the units of the code (m, rad).
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/cloud/cloud.h"
#include "core/geometry/axis.h"
#include "core/geometry/pose.h"
#include "core/registration/step_evidence.h"
#include "core/registration/verdict.h"

namespace gripscan {

/// How a held part moved against the gripper during a step.
struct GripSlip {
    double shift_m = 0.0;  ///< of the part's centre
    double angle_rad = 0.0;
    double sigma_shift_m = 0.0;  ///< standard deviations, along and about the motion that was found
    double sigma_angle_rad = 0.0;
};

/// One row of Table 1: the step from one used capture to the next.
struct TurnStep {
    int index = 0;  ///< 1, 2, …
    int from = 0;   ///< capture indices as in captures.csv
    int to = 0;
    int attempts = 1;
    std::optional<double> commanded_rad;  ///< of this step
    std::optional<double> robot_rad;      ///< difference of the measured joint
    std::optional<double> icp_rad;        ///< signed rotation angle of T; nothing if none was found
    /// icp − (robot, else commanded); nothing where the axis lock repeats that angle.
    std::optional<double> error_rad;
    std::optional<double> sigma_rad;      ///< predicted standard deviation of icp
    std::optional<double> observability;  ///< 0 (turn invisible in the surface) … 1
    TurnMode mode = TurnMode::kFree;
    bool independent = true;
    std::optional<double> tilt_rad;       ///< angle between this step's axis and the common one
    std::optional<double> axis_offset_m;  ///< distance of the two axes at the template's centre
    std::optional<double> slip_m;         ///< shift along the axis
    std::optional<Pose> T;                ///< x_to = T · x_from, camera frame
    std::optional<double> overlap;        ///< 0 … 1
    std::optional<double> rms_m;          ///< of the inliers, along the normal
    std::optional<double> median_m;       ///< of their absolute residuals
    std::optional<double> p90_m;
    Verdict verdict = Verdict::kReject;
    Cause cause = Cause::kNone;
    std::string sentence;               ///< the verdict in words: value, limit, reason
    std::optional<GripSlip> grip_slip;  ///< of an object in the gripper
};

struct AxisEstimate {
    Axis axis;  ///< point nearest the template's centroid; right-hand rule for the positive turn
    double sd_rad = 0.0;
    double sd_m = 0.0;
};

/// Composition of all steps against the nominal total.
struct Closure {
    double angle_rad = 0.0;
    double shift_m = 0.0;  ///< of the axis point nearest the template's centroid
};

struct TurnReport {
    SignSource sign_source = SignSource::kAssumed;
    TurnLimits limits;
    std::vector<TurnStep> steps;
    std::vector<StepEvidence> evidence;  ///< behind each step; not stored
    std::optional<AxisEstimate> axis;
    std::optional<Closure> closure_before;  ///< both or none
    std::optional<Closure> closure_after;
    /// T_first_k for every line of captures.csv; nothing where the capture was not merged.
    std::vector<std::optional<Pose>> poses;
    std::optional<double> angle_scale;  ///< estimated robot scale, where the data say so
    Cloud merged;                       ///< the template, in the frame of the first used capture
};

/// Accept or accept_noted.
[[nodiscard]] bool trusted(const TurnStep& step);
[[nodiscard]] std::size_t trusted_steps(const TurnReport& report);
/// Every used step of them.
[[nodiscard]] bool all_trusted(const TurnReport& report);

}  // namespace gripscan
