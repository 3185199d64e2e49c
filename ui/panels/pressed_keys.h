// The keys of this frame as the texts that the tables of keys use.
#pragma once

#include <string>
#include <vector>

namespace gripscan::ui {

/// "F", "Home", "Ctrl+1", "Esc": keys that went down in this frame. None while text is typed or a
/// menu is open.
[[nodiscard]] std::vector<std::string> pressed_view_keys();

}  // namespace gripscan::ui
