// Which key was pressed, by its name as it is shown.
#pragma once

#include <string>

namespace gripscan::ui {

/// "C", "Ctrl Z", "F1", "Space", "Esc": pressed anew in this frame; empty: none, or a modifier
/// alone.
[[nodiscard]] std::string pressed_key();

}  // namespace gripscan::ui
