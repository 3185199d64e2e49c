// What the status bar says of robot, joints and the turn. Pure.
#pragma once

#include <string>

#include "ui/theme/state.h"
#include "ui/views/cursor_reading.h"
#include "ui/views/snapshot.h"

namespace gripscan::ui {

struct StatusText {
    std::string robot;  ///< "Ready", "Moving to 150.0°", "Offline: …"
    State robot_state = State::kWaiting;
    std::string joint6;        ///< "140.001°"; empty: unknown
    std::string other_joints;  ///< "J1–J5 still", "J2 moved 0.31°"; empty: unknown
    bool others_moved = false;
    int checks = 0;
    int rejected = 0;
};
[[nodiscard]] StatusText status_of(const Snapshot& snapshot);

/// "x −12.42  y 8.07  z 738.61 mm".
[[nodiscard]] std::string cursor_text(const CursorReading& reading);
/// "42 s", "5 min 12 s", "2 h 05 min": rounded down.
[[nodiscard]] std::string duration_text(double seconds);

}  // namespace gripscan::ui
