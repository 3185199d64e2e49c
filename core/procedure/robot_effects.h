// The procedure's effects on the robot, as the events they end in. Without a robot (null) a link is
// open that reads nothing, and nothing can be turned.
#pragma once

#include <stop_token>

#include "core/procedure/input.h"

namespace gripscan {

[[nodiscard]] Event open_link(RobotLink* robot);
[[nodiscard]] Event turn(RobotLink* robot, const Joint6Command& command, std::stop_token stop);

}  // namespace gripscan
