// Without motion rights: asks the operator on the terminal to turn the joint.
#pragma once

#include <optional>
#include <stop_token>

#include "core/procedure/input.h"

namespace gripscan::app {

/// Asks for a turn to `target_rad`, or without one where the joint stands now. Waits for a line of
/// standard input: empty, the robot is read (`readable`); a number, the angle of joint 6 in deg as
/// the operator reads it. Asks again for anything else. Errors: the input has ended, cancelled.
[[nodiscard]] Result<Command> prompt_for_angle(const std::optional<double>& target_rad,
                                               bool readable, std::stop_token stop);

}  // namespace gripscan::app
