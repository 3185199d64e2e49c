// The bar on top: logo, pages, session, undo and redo, and what concerns the window.
#pragma once

#include "ui/views/request.h"
#include "ui/views/snapshot.h"
#include "ui/widgets/ui.h"

namespace gripscan::ui {

void draw_top_bar(const Ui& ui, const Rect& rect, const Snapshot& snapshot, Requests& out);

}  // namespace gripscan::ui
