// From an alignment of two views to a row of Table 1: what the robot reported, what the scans say,
// how the step deviates from the common axis, and the verdict.
#pragma once

#include <optional>
#include <span>

#include "core/registration/align.h"
#include "core/registration/axis_estimate.h"
#include "core/registration/solve_turn.h"
#include "core/registration/turn_report.h"

namespace gripscan {

/// Joint 6 of a view: the mean of the readings around the exposure.
[[nodiscard]] std::optional<double> joint6_rad(const TurnView& view);
/// to − from, where both are known.
[[nodiscard]] std::optional<double> difference(std::optional<double> from,
                                               std::optional<double> to);
/// What the step is compared with: the robot's angle, else the commanded one.
[[nodiscard]] std::optional<double> reported_rad(const TurnStep& step);

/// The row as far as it does not need the common axis. Index is left to the caller.
[[nodiscard]] TurnStep step_row(const TurnView& from, const TurnView& to,
                                const Alignment& alignment, TurnMethod method);

/// The axis from the steps alone; its sign is settled by the hint, else by what was reported.
struct StepsAxis {
    std::optional<AxisEstimate> estimate;  ///< nothing if no step turns
    SignSource sign_source = SignSource::kAssumed;
};
[[nodiscard]] StepsAxis axis_from_steps(std::span<const TurnStep> steps,
                                        const std::optional<Eigen::Vector3d>& axis_hint,
                                        const Eigen::Vector3d& centre_m);

/// Fills what the axis tells (signed angle, tilt, offset, slip, error) and judges the row.
void judge_row(TurnStep& step, const TurnView& from, const TurnView& to, const Alignment& alignment,
               const std::optional<AxisEstimate>& axis, const TurnSettings& settings);

}  // namespace gripscan
