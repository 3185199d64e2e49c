// From an alignment of two views to a row of Table 1: what the robot reported, what the scans say,
// how the step deviates from the common axis, and the verdict.
#pragma once

#include <optional>
#include <span>

#include "core/registration/align.h"
#include "core/registration/axis_estimate.h"
#include "core/registration/step_evidence.h"
#include "core/registration/turn_report.h"
#include "core/registration/turn_settings.h"
#include "core/registration/turn_view.h"

namespace gripscan {

/// Joint 6 of a capture: the mean of the readings around the exposure.
[[nodiscard]] std::optional<double> joint6_rad(const CaptureFacts& view);
/// to − from, where both are known.
[[nodiscard]] std::optional<double> difference(std::optional<double> from,
                                               std::optional<double> to);
/// What the step is compared with: the robot's angle, else the commanded one.
[[nodiscard]] std::optional<double> reported_rad(const TurnStep& step);

/// The row as far as it does not need the common axis. Index is left to the caller.
[[nodiscard]] TurnStep step_row(const CaptureFacts& from, const CaptureFacts& to,
                                const Alignment& alignment, TurnMethod method);

/// The axis from the free steps alone; its sign is settled by the hint, else by what was reported.
struct StepsAxis {
    std::optional<AxisEstimate> estimate;  ///< nothing if no step turns
    SignSource sign_source = SignSource::kAssumed;
};
[[nodiscard]] StepsAxis axis_from_steps(std::span<const TurnStep> steps,
                                        const std::optional<Eigen::Vector3d>& axis_hint,
                                        const Eigen::Vector3d& centre_m);

/// Fills what the axis tells: signed angle, tilt, offset, slip, error.
void compare_with_axis(TurnStep& step, const std::optional<AxisEstimate>& axis);

/// Views that are too poor to register are no error of the recording: the steps they take part in
/// have this in place of an alignment. Nothing if the view is usable.
[[nodiscard]] std::optional<Alignment> without_alignment(const CaptureFacts& facts,
                                                         const PreparedView& view);

/// What alignment and joints say beside the row.
[[nodiscard]] StepEvidence evidence_of(const CaptureFacts& from, const CaptureFacts& to,
                                       const Alignment& alignment, TurnMethod method);

}  // namespace gripscan
