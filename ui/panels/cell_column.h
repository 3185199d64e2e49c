// Right of the cell check: the robot, the camera and the limits of the turn.
#pragma once

#include "ui/layout/rect.h"
#include "ui/views/request.h"
#include "ui/views/snapshot.h"
#include "ui/widgets/ui.h"

namespace gripscan::ui {

void draw_cell_column(const Ui& ui, const Rect& column, const Snapshot& snapshot, Requests& out);

}  // namespace gripscan::ui
