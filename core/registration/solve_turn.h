// The whole turn: every step registered and checked against the robot, the axis, the joint
// solution, the template.
#pragma once

#include <span>

#include "core/registration/align.h"
#include "core/registration/turn_report.h"

namespace gripscan {

/// One used capture.
struct TurnView {
    int index = 0;                           ///< as in captures.csv
    Cloud cloud;                             ///< camera frame, cropped to the registration area
    std::optional<double> commanded_rad;     ///< turn since the first capture
    std::optional<double> joint6_rad;        ///< measured before the exposure
    std::optional<double> joint6_after_rad;  ///< measured after it
    /// J1 … J5, where they were read.
    std::optional<std::array<double, 5>> other_joints_rad;
    int attempts = 1;
    std::string note;  ///< accepted by the operator against the verdict; empty: not
};

enum class TurnMethod { kTurn, kPaperIcp };

struct TurnSettings {
    TurnMethod method = TurnMethod::kTurn;
    AlignSettings align;
    PaperIcpSettings paper_icp;
    TurnLimits limits;
    double step_rad = 0.17453292519943295;     ///< nominal
    std::optional<Eigen::Vector3d> axis_hint;  ///< direction of the positive turn
    double voxel_m = 1.0e-3;                   ///< of the template
    int min_seen = 2;                          ///< views that must have seen a template point
};

/// `report.poses` has one entry per view, in order. Errors: fewer than two views, fewer than two
/// with enough points to register, or cancelled. Bad steps and poor views are rows of the report.
[[nodiscard]] Result<TurnReport> solve_turn(std::span<const TurnView> views,
                                            const TurnSettings& settings, const Progress& progress,
                                            const ForEach& for_each);

}  // namespace gripscan
