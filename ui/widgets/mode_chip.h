// SIM, DRY, LIVE or MANUAL: what the robot may do, by word, border and colour. Always the first
// thing in the status bar.
#pragma once

#include <string_view>

#include "ui/widgets/ui.h"

namespace gripscan::ui {

enum class RobotMode {
    kSim,     ///< simulated cell, no robot moves
    kDry,     ///< robot linked, no motion is sent
    kLive,    ///< the robot moves
    kManual,  ///< the operator moves it
};

[[nodiscard]] std::string_view word(RobotMode mode);
[[nodiscard]] std::string_view sentence(RobotMode mode);

/// Its middle at `y`; returns the x where it ends.
int draw_mode_chip(const Ui& ui, int x, float y, RobotMode mode);

}  // namespace gripscan::ui
