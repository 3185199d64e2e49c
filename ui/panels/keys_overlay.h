// F1: every key, in groups.
#pragma once

#include "ui/layout/rect.h"
#include "ui/views/request.h"
#include "ui/views/snapshot.h"
#include "ui/widgets/ui.h"

namespace gripscan::ui {

struct KeysOverlayState {
    std::string search;
};

/// In the middle of `screen`, the whole window; nothing behind it takes the mouse.
void draw_keys_overlay(const Ui& ui, const Rect& screen, const Snapshot& snapshot,
                       KeysOverlayState& local, Requests& out);

}  // namespace gripscan::ui
