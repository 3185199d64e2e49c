// Steps that several checks with motion share.
#pragma once

#include <optional>
#include <string>

#include "core/robot/conformance_probe.h"

namespace gripscan::gsp {

inline constexpr double kEndTolerance_deg = 0.05;    ///< of joint 6 at its target
inline constexpr double kStillTolerance_deg = 0.02;  ///< of a joint that does not move

[[nodiscard]] std::optional<double> joint6_deg(Probe& probe);
/// Not longer than a turn may take.
void wait_until_it_stands(Probe& probe);
/// Does joint 6 stand at that angle, also a moment later?
[[nodiscard]] bool stands_at(Probe& probe, std::optional<double> angle_deg);

/// With a new id, to `steps` away from where the arm stood first.
[[nodiscard]] TurnJoint6 next_turn(Probe& probe, double steps);
/// Empty if ACC came, else what came.
[[nodiscard]] std::string trouble_with_acceptance(Probe& probe, const TurnJoint6& turn);
/// The line that ends a turn whose ACC has come.
[[nodiscard]] std::string end_of_turn(Probe& probe);
[[nodiscard]] bool is_done_at(std::string_view line, const TurnJoint6& turn);

/// Makes a turn from beginning to end; joint 6 has to stand where DONE says.
[[nodiscard]] Verdict make(Probe& probe, const TurnJoint6& turn);
/// Asks for a turn that has to be refused with that code and must move nothing. If it is taken all
/// the same, the arm is stopped at once.
[[nodiscard]] Verdict is_refused(Probe& probe, const TurnJoint6& turn, ErrorCode code);

// Checks of ids and refusals.

[[nodiscard]] Verdict learns_the_last_id(Probe& probe);
[[nodiscard]] Verdict repeats_without_moving(Probe& probe);
[[nodiscard]] Verdict refuses_other_arguments(Probe& probe);
[[nodiscard]] Verdict refuses_old_ids(Probe& probe);
[[nodiscard]] Verdict refuses_far_targets(Probe& probe);
[[nodiscard]] Verdict refuses_speeds(Probe& probe);

}  // namespace gripscan::gsp
