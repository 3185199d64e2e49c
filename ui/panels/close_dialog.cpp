#include "ui/panels/close_dialog.h"

#include <array>

#include "ui/panels/panel_parts.h"
#include "ui/widgets/dialog_frame.h"

namespace gripscan::ui {

void draw_close_dialog(const Ui& ui, const Rect& screen, const Snapshot& snapshot,
                       CloseDialogState& local, Requests& out) {
    DialogFrame frame(ui, screen,
                      {.id = "dialog.close",
                       .title = local.quits ? "Stop and quit?" : "Stop and close the session?",
                       .body_height = ui.em(6.5F)});
    Form form(ui, frame.body());
    form.words(snapshot.job ? snapshot.job->name + " is going on." : "Something is going on.",
               ui.theme.text);
    form.gap(0.57F);
    form.words(
        "It is stopped first, the arm too. Every capture so far is safe in the session; the start "
        "page offers to go on with it.",
        ui.theme.text_second);
    frame.end_body(form.y);
    const std::array<ButtonSpec, 2> buttons{
        {{.id = "close.stop",
          .label = local.quits ? "Stop and quit" : "Stop and close",
          .icon = Icon::kStop,
          .look = ButtonLook::kStop},
         {.id = "close.stay", .label = "Keep going", .key = "Enter", .look = ButtonLook::kNext}}};
    const auto pressed = dialog_buttons(ui, frame, buttons);
    frame.end();
    if (pressed || frame.closed()) out.push_back(request::Show{Dialog::kNone});
    if (pressed == 0U) {
        out.push_back(request::CloseSession{true});
        if (local.quits) out.push_back(request::Quit{});
    }
}

}  // namespace gripscan::ui
