#include "ui/panels/new_session_dialog.h"

#include <array>
#include <cmath>

#include "ui/panels/panel_parts.h"
#include "ui/views/fault_names.h"
#include "ui/widgets/choice.h"
#include "ui/widgets/dialog_frame.h"
#include "ui/widgets/interact.h"
#include "ui/widgets/number_input.h"
#include "ui/widgets/rich_text.h"
#include "ui/widgets/state_shape.h"
#include "ui/widgets/text_input.h"
#include "ui/widgets/tooltip.h"

namespace gripscan::ui {
namespace {

constexpr std::string_view kLiveWarning =
    "LIVE moves the robot. gripscan is no safety function: the fence, the pendant and the "
    "emergency stop are. By hand the arm moves only while Hold to move is held; Run to 360° goes "
    "on by itself until Pause or Stop.";

void draw_where(Form& form, TypedSession& typed) {
    const std::array<Option, 2> cells{
        {{"new.simulated", "Simulated"}, {"new.file", "From a cell file"}}};
    if (const auto chosen = segments(form.ui, form.row("Cell"), cells, typed.simulated ? 0 : 1)) {
        typed.simulated = *chosen == 0;
    }
    if (!typed.simulated) {
        (void)text_input(form.ui, form.row("Cell file"),
                         {.id = "new.cell_file",
                          .label = "Cell file",
                          .placeholder = "~/cells/cell-3.yaml",
                          .icon = Icon::kFolder,
                          .numbers = true},
                         typed.cell_file);
    }
    (void)text_input(form.ui, form.row("Folder"),
                     {.id = "new.folder",
                      .label = "Folder",
                      .placeholder = "a new one beside the others",
                      .icon = Icon::kFolder,
                      .numbers = true},
                     typed.folder);
}

/// What turns: the gripper alone, or what it holds.
void draw_part(Form& form, const Snapshot& snapshot, TypedSession& typed) {
    const std::array<Option, 2> parts{
        {{"new.gripper", "Gripper"}, {"new.object", "Object in the gripper"}}};
    SessionWish& wish = typed.wish;
    if (const auto chosen = segments(form.ui, form.row("Part"), parts, wish.object ? 1 : 0)) {
        wish.object = *chosen == 1;
    }
    if (!wish.object) return;
    (void)text_input(form.ui, form.row("Gripper"),
                     {.id = "new.gripper_session",
                      .label = "Gripper",
                      .placeholder = "its session folder, or template.pcd",
                      .icon = Icon::kFolder,
                      .numbers = true},
                     typed.gripper);
    if (!typed.simulated) return;
    std::vector<std::string> ids;
    for (const std::string& name : snapshot.sim_objects) ids.push_back("new.holds." + name);
    std::vector<Option> options;
    std::size_t now = snapshot.sim_objects.size();
    for (std::size_t i = 0; i < ids.size(); ++i) {
        options.push_back({ids[i], snapshot.sim_objects[i]});
        if (snapshot.sim_objects[i] == wish.sim_object) now = i;
    }
    if (const auto chosen = segments(form.ui, form.row("It holds"), options, now)) {
        wish.sim_object = snapshot.sim_objects[*chosen];
    }
}

void draw_turn(Form& form, SessionWish& wish) {
    const Ui& ui = form.ui;
    const Rect row = form.row("Step");
    const int width = ui.em(7.0F);
    const auto step = number_input(ui, {row.x, row.y, width, row.height},
                                   {.id = "new.step",
                                    .label = "Step",
                                    .value = wish.step_deg,
                                    .unit = "deg",
                                    .decimals = 1,
                                    .min = 1.0,
                                    .max = 90.0});
    if (step.committed) wish.step_deg = *step.committed;
    const Rect speed{row.right() - width, row.y, width, row.height};
    draw_text(ui, static_cast<float>(speed.x) - ui.scale.em(0.71F), middle_of(row),
              FontRole::kTable, ui.theme.text_second, "Speed", Align::kRight);
    const auto percent = number_input(ui, speed,
                                      {.id = "new.speed",
                                       .label = "Speed",
                                       .value = wish.speed_percent,
                                       .unit = "%",
                                       .decimals = 0,
                                       .min = 1.0,
                                       .max = 100.0});
    if (percent.committed) wish.speed_percent = *percent.committed;
}

void draw_faults(Form& form, SessionWish& wish) {
    const Ui& ui = form.ui;
    const Rect row = form.row("Seed");
    const auto seed = number_input(ui, {row.x, row.y, ui.em(7.0F), row.height},
                                   {.id = "new.seed",
                                    .label = "Seed",
                                    .value = static_cast<double>(wish.seed),
                                    .decimals = 0,
                                    .min = 1.0,
                                    .max = 999999.0});
    if (seed.committed) wish.seed = static_cast<std::uint64_t>(std::llround(*seed.committed));
    draw_text(ui, static_cast<float>(row.x) + ui.scale.em(7.71F), middle_of(row), FontRole::kSmall,
              ui.theme.text_third, "the same seed gives the same images");
    const auto faults = fault_names();
    constexpr int kColumns = 3;
    const int rows = (static_cast<int>(faults.size()) + kColumns - 1) / kColumns;
    const Rect area = form.row("Faults", 1.64F * static_cast<float>(rows));
    const int width = area.width / kColumns;
    for (std::size_t i = 0; i < faults.size(); ++i) {
        const int column = static_cast<int>(i) / rows;
        const int line = static_cast<int>(i) % rows;
        const Rect at{area.x + column * width, area.y + line * ui.em(1.64F), width, ui.em(1.64F)};
        if (check_box(ui, at, std::string("new.fault.") + std::string(faults[i].name),
                      faults[i].name, has_fault(wish.faults, faults[i].name))) {
            wish.faults = toggled(std::move(wish.faults), faults[i].name);
        }
        tooltip(ui, {faults[i].name, {}, faults[i].meaning});
    }
}

void draw_rights(Form& form, SessionWish& wish) {
    const Ui& ui = form.ui;
    const std::array<Option, 3> rights{
        {{"new.dry", "DRY"}, {"new.live", "LIVE"}, {"new.manual", "By hand"}}};
    const std::size_t now = wish.live ? 1 : wish.manual ? 2 : 0;
    if (const auto chosen = segments(ui, form.row("Motion"), rights, now)) {
        wish.live = *chosen == 1;
        wish.manual = *chosen == 2;
    }
    const std::string_view text =
        wish.live ? kLiveWarning
        : wish.manual
            ? "You turn joint 6 with the pendant; gripscan reads its angle, or asks for it."
            : "The robot is read; motions are written down and not sent.";
    form.y -= ui.em(0.29F);
    if (wish.live) {
        const int left = form.body.x + ui.em(form.label_em);
        const TextStyle small{FontRole::kTable, FontRole::kNumberTable, 1.5F};
        const int width = form.body.right() - left - ui.em(3.4F);
        const int height = rich_text_height(ui, width, text, small) + 2 * ui.em(0.57F);
        const Rect card{left, form.y, form.body.right() - left, height};
        fill(card, ui.theme.check_bg, ui.scale.em(0.36F));
        draw_state(ui, static_cast<float>(card.x) + ui.scale.em(1.43F),
                   static_cast<float>(card.y) + ui.scale.em(1.3F), State::kCheck, 1.14F,
                   ui.theme.check_bg);
        draw_rich_text(ui, card.x + ui.em(2.7F), card.y + ui.em(0.57F), width, ui.theme.text, text,
                       small);
        form.y = card.bottom();
    } else {
        form.words(text, ui.theme.text_third, true);
    }
    form.gap(0.57F);
}

}  // namespace

void draw_new_session_dialog(const Ui& ui, const Rect& screen, const Snapshot& snapshot,
                             NewSessionState& local, Requests& out) {
    TypedSession& typed = local.typed;
    const float of_part = !typed.wish.object ? 2.6F : typed.simulated ? 7.8F : 5.2F;
    const float body = of_part + (typed.simulated ? 24.9F : typed.wish.live ? 21.1F : 16.6F);
    DialogFrame frame(ui, screen,
                      {.id = "dialog.new",
                       .title = "New session",
                       .width_em = 38.0F,
                       .body_height = ui.em(body)});
    Form form(ui, frame.body());
    draw_where(form, typed);
    draw_part(form, snapshot, typed);
    draw_turn(form, typed.wish);
    if (typed.simulated) {
        draw_faults(form, typed.wish);
    } else {
        draw_rights(form, typed.wish);
    }
    frame.end_body(form.y);
    const std::string problem = session_problem(typed);
    draw_text(ui, static_cast<float>(frame.footer().x), middle_of(frame.footer()), FontRole::kSmall,
              ui.theme.text_third,
              fitted(ui, FontRole::kSmall, problem,
                     static_cast<float>(frame.footer().width) - ui.scale.em(18.0F)));
    const bool live = !typed.simulated && typed.wish.live;
    const std::array<ButtonSpec, 2> buttons{{{.id = "new.cancel", .label = "Cancel"},
                                             {.id = "new.begin",
                                              .label = live ? "Begin LIVE" : "Begin",
                                              .icon = Icon::kPlay,
                                              .key = "Enter",
                                              .look = ButtonLook::kNext,
                                              .why_disabled = problem}}};
    const auto pressed = dialog_buttons(ui, frame, buttons);
    frame.end();
    if (pressed == 1U) out.push_back(request::Begin{session_wish(typed)});
    if (pressed || frame.closed()) out.push_back(request::Show{Dialog::kNone});
}

}  // namespace gripscan::ui
