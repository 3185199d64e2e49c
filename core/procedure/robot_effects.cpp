#include "core/procedure/robot_effects.h"

namespace gripscan {

Event open_link(RobotLink* robot) {
    event::LinkUp up;
    if (robot == nullptr) return up;
    auto identity = robot->connect();
    if (!identity) return event::LinkDown{identity.error().message};
    auto controller = robot->state();
    if (!controller) return event::LinkDown{controller.error().message};
    auto reading = robot->read();
    if (!reading) return event::LinkDown{reading.error().message};
    up.identity = std::move(*identity);
    up.controller = std::move(*controller);
    up.reading = *reading;
    return up;
}

Event turn(RobotLink* robot, const Joint6Command& command, std::stop_token stop) {
    if (robot == nullptr) {
        return event::TurnFailed{RobotFault::kUnreachable, 0, "the cell has no robot to turn"};
    }
    auto reading = robot->turn_joint6(command, std::move(stop));
    if (reading) return event::Arrived{*reading};
    const RobotError& error = reading.error();
    return event::TurnFailed{error.fault, error.last_id, error.message};
}

}  // namespace gripscan
