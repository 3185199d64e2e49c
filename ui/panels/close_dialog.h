// Something is going on: stop it and close?
#pragma once

#include "ui/layout/rect.h"
#include "ui/views/request.h"
#include "ui/views/snapshot.h"
#include "ui/widgets/ui.h"

namespace gripscan::ui {

struct CloseDialogState {
    bool quits = true;  ///< the window is closed; else only the session
};

/// In the middle of `screen`, the whole window; nothing behind it takes the mouse.
void draw_close_dialog(const Ui& ui, const Rect& screen, const Snapshot& snapshot,
                       CloseDialogState& local, Requests& out);

}  // namespace gripscan::ui
