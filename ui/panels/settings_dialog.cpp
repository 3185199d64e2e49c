#include "ui/panels/settings_dialog.h"

#include <array>
#include <cmath>

#include "ui/panels/panel_parts.h"
#include "ui/views/key_table.h"
#include "ui/widgets/choice.h"
#include "ui/widgets/dialog_frame.h"
#include "ui/widgets/interact.h"
#include "ui/widgets/key_press.h"
#include "ui/widgets/notices.h"
#include "ui/widgets/number_input.h"

namespace gripscan::ui {
namespace {

constexpr float kRow = 2.14F;
constexpr float kBody = 21.0F;

void draw_scale(Form& form, const WindowPreferences& wanted, Requests& out) {
    const Ui& ui = form.ui;
    constexpr std::array<double, 4> kFactors{1.0, 1.25, 1.5, 2.0};
    const std::array<Option, 4> options{{{"settings.scale100", "100 %"},
                                         {"settings.scale125", "125 %"},
                                         {"settings.scale150", "150 %"},
                                         {"settings.scale200", "200 %"}}};
    const Rect row = form.row("Scale");
    const int field = ui.em(6.0F);
    std::size_t now = kFactors.size();
    for (std::size_t i = 0; i < kFactors.size(); ++i) {
        if (std::abs(kFactors[i] - wanted.user_scale) < 1e-6) now = i;
    }
    if (const auto chosen = segments(
            ui, {row.x, row.y, row.width - field - ui.em(0.57F), row.height}, options, now)) {
        out.push_back(request::SetScale{kFactors[*chosen]});
    }
    const auto typed = number_input(ui, {row.right() - field, row.y, field, row.height},
                                    {.id = "settings.scale",
                                     .label = "Scale",
                                     .value = 100.0 * wanted.user_scale,
                                     .unit = "%",
                                     .decimals = 0,
                                     .min = 50.0,
                                     .max = 400.0});
    if (typed.committed) out.push_back(request::SetScale{*typed.committed / 100.0});
}

void draw_looks(Form& form, const WindowPreferences& wanted, Requests& out) {
    const Ui& ui = form.ui;
    const std::array<Option, 2> themes{
        {{"settings.dark", "Dark"}, {"settings.light", "Light, for bright halls"}}};
    if (const auto chosen =
            segments(ui, form.row("Theme"), themes, wanted.theme == ThemeChoice::kDark ? 0 : 1)) {
        out.push_back(request::SetTheme{*chosen == 0 ? ThemeChoice::kDark : ThemeChoice::kLight});
    }
    draw_scale(form, wanted, out);
    form.y -= ui.em(0.36F);
    form.words("Times the scale of the monitor. Ctrl + and Ctrl − change it anywhere.",
               ui.theme.text_third, true);
    form.gap(0.71F);
    if (check_box(ui, form.row("Buttons"), "settings.large", "large, for gloves",
                  wanted.large_buttons)) {
        out.push_back(request::SetLargeButtons{!wanted.large_buttons});
    }
    const std::array<Option, 3> presets{
        {{"settings.gripscan", "gripscan"}, {"settings.cad", "CAD"}, {"settings.rviz", "RViz"}}};
    const std::size_t now = wanted.navigation == "CAD" ? 1 : wanted.navigation == "RViz" ? 2 : 0;
    if (const auto chosen = segments(ui, form.row("3D mouse"), presets, now)) {
        out.push_back(request::SetNavigation{std::string(presets[*chosen].label)});
    }
    const Rect layout = form.row("Layout", 2.57F);
    if (button(ui, {layout.x, layout.y, ui.em(11.0F), ui.em(2.57F)},
               {.id = "settings.layout", .label = "Reset the layout", .icon = Icon::kUndo})) {
        out.push_back(request::ResetLayout{});
    }
}

void draw_key(const Ui& ui, const Rect& row, const KeyBinding& key, SettingsState& local,
              Requests& out) {
    const bool waiting = local.waiting_for == key.action;
    draw_text(ui, static_cast<float>(row.x), middle_of(row), FontRole::kTable, ui.theme.text,
              key.label);
    const int width = ui.em(9.0F);
    const int reset = ui.em(4.0F);
    const Rect at{row.right() - reset - width, row.y + ui.em(0.14F), width,
                  row.height - 2 * ui.em(0.14F)};
    if (button(ui, at,
               {.id = "settings.key." + key.action,
                .label = waiting ? "press a key …" : std::string_view(key.key),
                .look = waiting ? ButtonLook::kSecond : ButtonLook::kNormal})) {
        local.waiting_for = waiting ? std::string() : key.action;
        local.problem.clear();
    }
    if (key.key != key.standard && link(ui, {at.right(), row.y, reset, row.height},
                                        "settings.key." + key.action + ".reset", "reset")) {
        out.push_back(request::SetKey{key.action, {}});
    }
}

void draw_keys(Form& form, const Snapshot& snapshot, SettingsState& local, Requests& out) {
    const Ui& ui = form.ui;
    const std::string_view text = !local.problem.empty() ? std::string_view(local.problem)
                                                         : "Click a key, then press the new one.";
    form.words(text, local.problem.empty() ? ui.theme.text_third : ui.theme.reject);
    form.gap(0.43F);
    for (const KeyGroup& group : key_groups(snapshot.keys)) {
        form.y = draw_section(ui, form.body.x, form.y, group.name);
        for (const KeyBinding* key : group.keys) {
            const Rect row{form.body.x, form.y, form.body.width, ui.em(kRow)};
            draw_key(ui, row, *key, local, out);
            form.y = row.bottom();
        }
        form.gap(0.57F);
    }
}

/// The key that was waited for, if one was pressed; Escape takes the question back.
void take_key(const Snapshot& snapshot, SettingsState& local, Requests& out) {
    const auto pressed = pressed_keys();
    if (pressed.empty()) return;
    const std::string& key = pressed.front();
    if (key != "Esc") {
        local.problem = key_problem(snapshot.keys, local.waiting_for, key);
        if (local.problem.empty()) out.push_back(request::SetKey{local.waiting_for, key});
    }
    local.waiting_for.clear();
}

}  // namespace

void draw_settings_dialog(const Ui& ui, const Rect& screen, const Snapshot& snapshot,
                          SettingsState& local, Requests& out) {
    DialogFrame frame(ui, screen,
                      {.id = "dialog.settings",
                       .title = "Settings",
                       .width_em = 40.0F,
                       .body_height = ui.em(kBody)});
    if (frame.appeared()) {
        local.waiting_for.clear();
        local.problem.clear();
    }
    const bool waited = !local.waiting_for.empty();
    if (waited) take_key(snapshot, local, out);
    Form form(ui, frame.body());
    const std::array<Option, 2> pages{{{"settings.looks", "Looks"}, {"settings.keys", "Keys"}}};
    if (const auto chosen = tabs(ui, form.row({}, 2.43F), pages, local.tab)) local.tab = *chosen;
    if (local.tab == 0) {
        draw_looks(form, snapshot.preferences, out);
    } else {
        draw_keys(form, snapshot, local, out);
    }
    frame.end_body(form.y);
    const std::array<ButtonSpec, 1> buttons{
        {{.id = "settings.done", .label = "Done", .key = "Enter"}}};
    const auto pressed = dialog_buttons(ui, frame, buttons);
    frame.end();
    if (!waited && (pressed || frame.closed())) out.push_back(request::Show{Dialog::kNone});
}

}  // namespace gripscan::ui
