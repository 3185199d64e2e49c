// The cell: what its check found, the robot and the camera as they are, and the limits.
#pragma once

#include "ui/layout/rect.h"
#include "ui/views/request.h"
#include "ui/views/snapshot.h"
#include "ui/widgets/ui.h"

namespace gripscan::ui {

struct CellPageState {
    std::optional<std::size_t> selected;  ///< item of the check whose sentence is read
};

/// Fills `rect`, the window between stage bar and status bar.
void draw_cell_page(const Ui& ui, const Rect& rect, const Snapshot& snapshot, CellPageState& local,
                    Requests& out);

}  // namespace gripscan::ui
