#include "ui/panels/toasts.h"

#include <imgui.h>

#include <algorithm>

#include "ui/views/log_text.h"
#include "ui/widgets/button.h"
#include "ui/widgets/draw.h"
#include "ui/widgets/notices.h"

namespace gripscan::ui {

void draw_toasts(const Ui& ui, const Rect& view, const Snapshot& snapshot, Requests& out) {
    const int margin = ui.em(0.71F);
    const int width = std::min(ui.em(28.0F), view.width - 2 * margin);
    const int height = toast_height(ui);
    const int close = ui.em(1.71F);
    if (width < ui.em(10.0F)) return;
    int y = view.bottom() - margin - height;
    for (auto toast = snapshot.toasts.rbegin(); toast != snapshot.toasts.rend(); ++toast) {
        if (y < view.y) return;
        const Rect card{view.right() - margin - width, y, width, height};
        ui.log.record({"toast." + toast->id, toast->title, card, true, {}});
        // The words end before the cross.
        (void)draw_toast(ui, card,
                         {toast->id, state_of(toast->level), toast->title, toast->text, {}});
        const std::string close_id = "toast." + toast->id + ".close";
        const Rect cross{card.right() - close - ui.em(0.29F), card.y + ui.em(0.29F), close, close};
        fill(cross, ui.theme.panel);
        if (icon_button(ui, cross,
                        {.id = close_id, .label = {}, .icon = Icon::kClose, .tooltip = "Close"})) {
            out.push_back(request::CloseToast{toast->id});
        }
        y -= height + ui.em(0.43F);
    }
}

}  // namespace gripscan::ui
