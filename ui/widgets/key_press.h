// The keys of this frame, by the names under which the tables of keys know them.
#pragma once

#include <string>
#include <vector>

namespace gripscan::ui {

/// "C", "Ctrl+Z", "F1", "Space", "Esc": keys that went down in this frame. Letters are those that
/// stand on the keys, whatever the layout; Esc is Esc with any other key.
[[nodiscard]] std::vector<std::string> pressed_keys();

/// The same for what keys do in the window: none while text is typed or a menu is open.
[[nodiscard]] std::vector<std::string> command_keys();

}  // namespace gripscan::ui
