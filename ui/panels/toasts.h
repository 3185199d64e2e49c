// Toasts in the corner of the 3D view. They never take the focus.
#pragma once

#include "ui/views/request.h"
#include "ui/views/snapshot.h"
#include "ui/widgets/ui.h"

namespace gripscan::ui {

/// `view`: the 3D view; the newest is at the bottom.
void draw_toasts(const Ui& ui, const Rect& view, const Snapshot& snapshot, Requests& out);

}  // namespace gripscan::ui
