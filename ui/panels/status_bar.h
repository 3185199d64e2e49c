// The bar at the bottom: what the robot may do, first; then how it stands, what goes on, and what
// has to be looked at.
#pragma once

#include "ui/layout/window_layout.h"
#include "ui/views/request.h"
#include "ui/views/status_text.h"
#include "ui/widgets/ui.h"

namespace gripscan::ui {

/// `cursor`: what the mouse points at in the 3D view.
void draw_status_bar(const Ui& ui, const Rect& rect, const Snapshot& snapshot, const Detail& detail,
                     const std::optional<CursorReading>& cursor, Requests& out);

}  // namespace gripscan::ui
