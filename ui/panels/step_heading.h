// The head of the step card: the dial, the number of the step, and the sums beside it.
#pragma once

#include "ui/layout/window_layout.h"
#include "ui/views/snapshot.h"
#include "ui/widgets/ui.h"

namespace gripscan::ui {

/// Returns its height.
int draw_step_heading(const Ui& ui, int x, int y, int width, const Snapshot& snapshot,
                      const Detail& detail);

}  // namespace gripscan::ui
