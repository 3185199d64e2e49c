// From trusted steps to the pose of every view: the joint solution, or the steps composed; and how
// well the turn closes.
#pragma once

#include "core/base/for_each.h"
#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/registration/joint_solution.h"
#include "core/registration/turn_report.h"
#include "core/registration/turn_settings.h"
#include "core/registration/turn_view.h"
#include "core/registration/view_chain.h"

namespace gripscan {

/// A surface that does not show its turn shows no ratio of the robot's either: with a locked step
/// the scale is known. So it is of what the gripper holds: the ratio is measured with the gripper,
/// whose shape shows it, and any object may be nearly round.
[[nodiscard]] JointSettings joint_settings(std::span<const CaptureFacts> facts,
                                           std::span<const PreparedView* const> views);

/// The turn of every member (places among the views, rising) since the first of them as reported;
/// where nothing was reported, as the steps say, loosely held; where the step is locked to the
/// axis, exactly as reported.
[[nodiscard]] std::vector<JointView> joint_views(std::span<const CaptureFacts> facts,
                                                 std::span<const PreparedView* const> views,
                                                 std::span<const std::size_t> members,
                                                 std::span<const TurnStep> steps);

/// Sets report.poses (relative to the first used capture, nothing where a view is not trusted);
/// with more than two trusted views and an axis, solves jointly and replaces report.axis, and sets
/// report.angle_scale where the data ask for one. Error: cancelled.
[[nodiscard]] Status solve_poses(std::span<const CaptureFacts> facts,
                                 std::span<const PreparedView* const> views, const ViewChain& chain,
                                 const TurnSettings& settings, const Progress& progress,
                                 const ForEach& for_each, TurnReport& report);

/// Do the steps make a whole turn, to half a step?
[[nodiscard]] bool spans_whole_turn(double step_rad, const TurnReport& report);

/// Closure of the steps and of the poses where the steps make a whole turn to half a step and all
/// of them were measured: with one locked to the axis a turn closes because the robot says so.
/// Shifts are those of the axis point of the report.
void set_closures(double step_rad, TurnReport& report);

}  // namespace gripscan
