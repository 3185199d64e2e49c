#include "tests/render/procedure_page.h"

#include "ui/panels/history_panel.h"
#include "ui/panels/stage_bar.h"
#include "ui/panels/status_bar.h"
#include "ui/panels/toasts.h"
#include "ui/panels/top_bar.h"
#include "ui/widgets/draw.h"

namespace gripscan::test {

void draw_procedure_page(const ui::Ui& ui, int width_px, int height_px, const Sample& sample,
                         ProcedurePageState& local, ui::PictureCache* pictures, ui::Requests& out) {
    using namespace gripscan::ui;
    const WindowLayout at =
        layout_window(width_px, height_px, default_splits(width_px, height_px, ui.scale), ui.scale);
    const Snapshot& s = sample.snapshot;
    fill({0, 0, width_px, height_px}, ui.theme.bg0);
    fill(at.stereo, ui.theme.panel);
    fill(at.view3d, ui.theme.view_top);
    draw_top_bar(ui, at.top_bar, s, out);
    draw_stage_bar(ui, at.stage_bar, s, at.detail, out);
    draw_step_card(ui, at.step_card, s, at.detail, local.card, out);
    draw_table_dock(ui, at.table, s, at.detail, local.dock, local.log, pictures, out);
    if (!at.history.empty()) draw_history_panel(ui, at.history, s, at.detail, local.log, out);
    draw_status_bar(ui, at.status_bar, s, at.detail,
                    CursorReading{{-0.01242, 0.00807, 0.73861}, 0.00018, 9}, out);
    draw_toasts(ui, at.view3d, s, out);
}

}  // namespace gripscan::test
