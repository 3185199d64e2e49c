// The whole turn: every step registered and checked against the robot, the axis, the joint
// solution, the template. In one call, or piece by piece as the captures come.
#pragma once

#include <span>
#include <vector>

#include "core/registration/step_finding.h"
#include "core/registration/turn_settings.h"
#include "core/registration/turn_view.h"

namespace gripscan {

/// The used captures in order with what has been made of them. Data belong to the caller.
struct PreparedTurn {
    std::vector<CaptureFacts> facts;
    std::vector<const PreparedView*> views;  ///< one a capture
    std::vector<StepFinding> steps;          ///< of view i onto view i + 1: one less
    /// Camera shift between views that are not neighbours; may be empty: not known.
    CameraShiftBetween camera_shift;
};

/// View `from` onto view `to` by the method of the settings. A view with a flaw gives an alignment
/// that was not found, with its reason. Error: cancelled.
[[nodiscard]] Result<Alignment> align_views(const CaptureFacts& from_facts,
                                            const PreparedView& from, const CaptureFacts& to_facts,
                                            const PreparedView& to, const TurnSettings& settings,
                                            const Progress& progress, const ForEach& for_each);

/// Rows, verdicts, axis, poses and template from what is there. `report.poses` has one entry per
/// view, in order. Errors: fewer than two views with enough points to register, cancelled.
[[nodiscard]] Result<TurnReport> finish_turn(const PreparedTurn& turn, const TurnSettings& settings,
                                             const Progress& progress, const ForEach& for_each);

/// All at once. Errors: fewer than two views, and those of finish_turn. Bad steps and poor views
/// are rows of the report.
[[nodiscard]] Result<TurnReport> solve_turn(std::span<const TurnView> views,
                                            const TurnSettings& settings, const Progress& progress,
                                            const ForEach& for_each);

}  // namespace gripscan
