// The panels of the procedure page in their places, with plain fields where the 3D view and the
// stereo images stand.
#pragma once

#include "tests/support/sample_snapshot.h"
#include "ui/panels/log_list.h"
#include "ui/panels/step_card.h"
#include "ui/panels/table_dock.h"

namespace gripscan::test {

struct ProcedurePageState {
    ui::StepCardState card;
    ui::TableDockState dock;
    ui::LogListState log;
};

/// `pictures` null: without images.
void draw_procedure_page(const ui::Ui& ui, int width_px, int height_px, const Sample& sample,
                         ProcedurePageState& local, ui::PictureCache* pictures, ui::Requests& out);

}  // namespace gripscan::test
