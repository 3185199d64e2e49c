#include "ui/panels/error_dialog.h"

#include <array>

#include "ui/panels/panel_parts.h"
#include "ui/widgets/dialog_frame.h"
#include "ui/widgets/rich_text.h"
#include "ui/widgets/state_shape.h"

namespace gripscan::ui {
namespace {

int body_height(const Ui& ui, const ShownError& error) {
    const int width = ui.em(34.0F) - 2 * ui.em(1.29F);
    const TextStyle small{FontRole::kTable, FontRole::kNumberTable, 1.5F};
    return rich_text_height(ui, width - ui.em(2.6F), error.what, small) +
           rich_text_height(ui, width - ui.em(2.6F), error.advice, small) + ui.em(2.9F);
}

}  // namespace

void draw_error_dialog(const Ui& ui, const Rect& screen, const Snapshot& snapshot,
                       ErrorDialogState& local, Requests& out) {
    const ShownError error =
        snapshot.error.value_or(ShownError{"Nothing has failed", {}, {}, {}, {}});
    DialogFrame frame(
        ui, screen,
        {.id = "dialog.error", .title = error.title, .body_height = body_height(ui, error)});
    if (frame.appeared()) local.copied = false;
    Form form(ui, frame.body());
    const float shape = static_cast<float>(form.y) + ui.scale.em(0.71F);
    draw_state(ui, static_cast<float>(form.body.x) + ui.scale.em(0.71F), shape, State::kReject,
               1.43F, ui.theme.panel);
    form.body.x += ui.em(2.6F);
    form.body.width -= ui.em(2.6F);
    form.words(error.what, ui.theme.text);
    form.gap(0.86F);
    if (!error.advice.empty()) {
        draw_text(ui, static_cast<float>(form.body.x),
                  static_cast<float>(form.y) + ui.scale.em(0.57F), FontRole::kTableStrong,
                  ui.theme.text, "What to do");
        form.gap(1.43F);
        form.words(error.advice, ui.theme.text_second);
    }
    frame.end_body(form.y);
    const bool acts = !error.action.empty();
    const std::array<ButtonSpec, 3> buttons{
        {{.id = "error.copy", .label = local.copied ? "Copied" : "Copy", .icon = Icon::kCopy},
         {.id = "error.close", .label = acts ? "Close" : ""},
         {.id = acts ? "error.action" : "error.close",
          .label = acts ? std::string_view(error.action) : "Close",
          .key = "Enter",
          .look = ButtonLook::kNext}}};
    const auto pressed = dialog_buttons(ui, frame, buttons);
    frame.end();
    if (pressed == 0U) {
        local.copied = true;
        out.push_back(request::CopyText{
            error.title + "\n" + error.what + (error.advice.empty() ? "" : "\n" + error.advice),
            "the message"});
    }
    if ((pressed && *pressed > 0) || frame.closed()) {
        out.push_back(request::Show{Dialog::kNone});
        if (pressed == 2U) out.insert(out.end(), error.does.begin(), error.does.end());
    }
}

}  // namespace gripscan::ui
