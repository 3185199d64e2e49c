// What the user may set: looks, keys, navigation.
#pragma once

#include "ui/layout/rect.h"
#include "ui/views/request.h"
#include "ui/views/snapshot.h"
#include "ui/widgets/ui.h"

namespace gripscan::ui {

struct SettingsState {
    std::size_t tab = 0;      ///< looks, keys
    std::string waiting_for;  ///< action whose new key is to be pressed
    std::string problem;      ///< why the last key was not taken
};

/// In the middle of `screen`, the whole window; nothing behind it takes the mouse.
void draw_settings_dialog(const Ui& ui, const Rect& screen, const Snapshot& snapshot,
                          SettingsState& local, Requests& out);

}  // namespace gripscan::ui
