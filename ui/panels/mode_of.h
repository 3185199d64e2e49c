// The chip of a plan's mode.
#pragma once

#include "core/procedure/turn_plan.h"
#include "ui/widgets/mode_chip.h"

namespace gripscan::ui {

[[nodiscard]] constexpr RobotMode mode_of(MotionMode mode) {
    switch (mode) {
        case MotionMode::kSim:
            return RobotMode::kSim;
        case MotionMode::kLive:
            return RobotMode::kLive;
        case MotionMode::kManual:
            return RobotMode::kManual;
        case MotionMode::kDry:
            break;
    }
    return RobotMode::kDry;
}

}  // namespace gripscan::ui
