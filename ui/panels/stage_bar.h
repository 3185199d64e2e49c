// The stages of the procedure, each with its state and what it has to reach.
#pragma once

#include "ui/layout/window_layout.h"
#include "ui/views/request.h"
#include "ui/views/snapshot.h"
#include "ui/widgets/ui.h"

namespace gripscan::ui {

void draw_stage_bar(const Ui& ui, const Rect& rect, const Snapshot& snapshot, const Detail& detail,
                    Requests& out);

}  // namespace gripscan::ui
