// Something failed: what, why, what to do.
#pragma once

#include "ui/layout/rect.h"
#include "ui/views/request.h"
#include "ui/views/snapshot.h"
#include "ui/widgets/ui.h"

namespace gripscan::ui {

struct ErrorDialogState {
    bool copied = false;
};

/// In the middle of `screen`, the whole window; nothing behind it takes the mouse.
void draw_error_dialog(const Ui& ui, const Rect& screen, const Snapshot& snapshot,
                       ErrorDialogState& local, Requests& out);

}  // namespace gripscan::ui
