// All keys of the window, those of the procedure and those of the 3D view, as overlay and settings
// list them.
#pragma once

#include <vector>

#include "ui/views/snapshot.h"

namespace gripscan::ui {

[[nodiscard]] std::vector<KeyBinding> key_bindings(const WindowPreferences& preferences);

}  // namespace gripscan::ui
