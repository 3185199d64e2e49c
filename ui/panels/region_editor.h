// The registration area as six numbers, and the way into the cell file.
#pragma once

#include "ui/views/request.h"
#include "ui/views/snapshot.h"
#include "ui/widgets/ui.h"

namespace gripscan::ui {

/// Returns its height.
int draw_region_editor(const Ui& ui, int x, int y, int width, const Snapshot& snapshot,
                       Requests& out);

}  // namespace gripscan::ui
