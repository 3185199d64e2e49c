// The menu of a row of Table 1: take its view again, leave it out, accept it with a note.
#pragma once

#include "ui/views/request.h"
#include "ui/views/snapshot.h"
#include "ui/widgets/ui.h"

namespace gripscan::ui {

/// From the next frame on, at the mouse.
void open_row_menu();
/// Draws it while it is open. `row` is an index into table_of.
void draw_row_menu(const Ui& ui, const Snapshot& snapshot, std::size_t row, Requests& out);

}  // namespace gripscan::ui
