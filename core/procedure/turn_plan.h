// What is planned before the first step: how far, how fast, within which limits.
#pragma once

#include <numbers>
#include <optional>
#include <string_view>

#include "core/base/units.h"
#include "core/registration/turn_report.h"

namespace gripscan {

/// Whether motions are sent, and how that is called on the screen.
enum class MotionMode {
    kSim,     ///< a simulated cell
    kDry,     ///< the link is read, motions are written down and not sent
    kLive,    ///< a real arm moves
    kManual,  ///< no motion rights: the operator turns the joint, gripscan reads or is told
};
/// "SIM", "DRY", "LIVE", "MANUAL".
[[nodiscard]] std::string_view word(MotionMode mode);

struct TurnPlan {
    MotionMode mode = MotionMode::kSim;
    double step_rad = 10.0 * kRadPerDeg;  ///< > 0
    double total_rad = 2.0 * std::numbers::pi;
    /// Joint 6 at the first capture; nothing: where it stands, or the lower end of its range where
    /// the whole turn would not fit from there.
    std::optional<double> start_joint6_rad;
    double speed_percent = 10.0;
    /// Every angle is approached rising: a target below is passed by so much first (backlash).
    double approach_rad = 3.0 * kRadPerDeg;
    double largest_move_rad = 90.0 * kRadPerDeg;  ///< longer motions are cut in pieces
    double warm_up_step_rad = 4.0 * kRadPerDeg;
    int warm_up_shots = 3;
    /// The warm-up begins where joint 6 stands: the way to the start of the turn is not driven
    /// before it is known what the gripper sweeps. Nothing: at the start of the turn.
    std::optional<bool> warm_up_in_place = true;
    TurnLimits limits;

    // What the advisor may spend.
    double least_step_rad = 2.0 * kRadPerDeg;
    int retakes_an_angle = 2;
    /// The step is at most halved so often; nothing: down to the least step.
    std::optional<int> halvings_a_turn = 3;
    int rejected_in_a_row = 3;  ///< so many and it stops
};

/// Joint 6 at the first capture: as planned, else where it stands, else, where the whole turn would
/// not fit from there, so that it lies evenly about zero.
[[nodiscard]] double start_of_turn(const TurnPlan& plan, double standing_joint6_rad);

}  // namespace gripscan
