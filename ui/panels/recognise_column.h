// Right of the recognised view: verdict, evidence of each template, the robot as witness, the
// library, and what can be done.
#pragma once

#include "ui/panels/recognise_page.h"

namespace gripscan::ui {

void draw_recognise_column(const Ui& ui, const Rect& column, const Snapshot& snapshot,
                           RecognisePageState& local, Requests& out);

}  // namespace gripscan::ui
