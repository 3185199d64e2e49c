#include "ui/panels/note_dialog.h"

#include <array>

#include "ui/panels/panel_parts.h"
#include "ui/views/accepted.h"
#include "ui/widgets/dialog_frame.h"
#include "ui/widgets/rich_text.h"
#include "ui/widgets/text_input.h"

namespace gripscan::ui {

void draw_note_dialog(const Ui& ui, const Rect& screen, const Snapshot& snapshot,
                      NoteDialogState& local, Requests& out) {
    const ProcedureState nothing;
    const Accepted accepted =
        accepted_by_note(snapshot.procedure != nullptr ? *snapshot.procedure : nothing);
    DialogFrame frame(ui, screen,
                      {.id = "dialog.note", .title = accepted.title, .body_height = ui.em(11.0F)});
    if (frame.appeared()) local.note.clear();
    Form form(ui, frame.body());
    form.words(accepted.finding, ui.theme.text);
    form.gap(0.57F);
    form.words("Accepted on your word. The note stands in the session and in the report.",
               ui.theme.text_second);
    form.gap(0.71F);
    const TextEvent typed = text_input(ui, form.row({}),
                                       {.id = "note.text",
                                        .label = "Note",
                                        .placeholder = "why it is right all the same",
                                        .take_keyboard = frame.appeared()},
                                       local.note);
    const std::string problem =
        accepted.refused.empty() ? note_problem(local.note) : accepted.refused;
    form.words(problem, ui.theme.text_third);
    frame.end_body(form.y);
    const std::array<ButtonSpec, 2> buttons{{{.id = "note.cancel", .label = "Cancel"},
                                             {.id = "note.accept",
                                              .label = "Accept",
                                              .icon = Icon::kCheck,
                                              .key = "Enter",
                                              .look = ButtonLook::kNext,
                                              .why_disabled = problem}}};
    const auto pressed = dialog_buttons(ui, frame, buttons);
    frame.end();
    const bool accept = pressed == 1U || (typed.entered && problem.empty());
    if (accept) out.push_back(request::Give{command::Accept{local.note}});
    if (accept || pressed == 0U || frame.closed()) out.push_back(request::Show{Dialog::kNone});
}

}  // namespace gripscan::ui
