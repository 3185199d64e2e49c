// From trusted steps to the pose of every view: the joint solution, or the steps composed; and how
// well the turn closes.
#pragma once

#include "core/base/for_each.h"
#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/registration/solve_turn.h"
#include "core/registration/surface.h"
#include "core/registration/turn_report.h"
#include "core/registration/view_chain.h"

namespace gripscan {

/// Sets report.poses (relative to the first used capture, nothing where a view is not trusted);
/// with more than two trusted views and an axis, solves jointly and replaces report.axis, and sets
/// report.angle_scale where the data ask for one. Error: cancelled.
[[nodiscard]] Status solve_poses(std::span<const TurnView> views, std::span<const Surface> surfaces,
                                 const ViewChain& chain, const TurnSettings& settings,
                                 const Progress& progress, const ForEach& for_each,
                                 TurnReport& report);

/// Closure of the steps and of the poses where the steps make a whole turn to half a step. Shifts
/// are those of the axis point of the report.
void set_closures(double step_rad, TurnReport& report);

}  // namespace gripscan
