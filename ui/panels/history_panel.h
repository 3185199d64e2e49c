// The error of every step, and the log below it where that is no tab.
#pragma once

#include "ui/layout/window_layout.h"
#include "ui/panels/log_list.h"

namespace gripscan::ui {

void draw_history_panel(const Ui& ui, const Rect& rect, const Snapshot& snapshot,
                        const Detail& detail, LogListState& log, Requests& out);

}  // namespace gripscan::ui
