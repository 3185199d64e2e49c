#include "ui/panels/keys_overlay.h"

#include <algorithm>
#include <array>

#include "ui/panels/panel_parts.h"
#include "ui/views/key_table.h"
#include "ui/widgets/dialog_frame.h"
#include "ui/widgets/text_input.h"

namespace gripscan::ui {
namespace {

constexpr float kRow = 1.79F;

int rows_of(const KeyGroup& group) {
    return static_cast<int>(group.keys.size()) + 2;  // its name, and room below
}

/// Groups in two columns of about the same height: how many stand in the first.
std::size_t in_first_column(const std::vector<KeyGroup>& groups) {
    int all = 0;
    for (const KeyGroup& group : groups) all += rows_of(group);
    int first = 0;
    std::size_t count = 0;
    while (count < groups.size() && 2 * first < all) first += rows_of(groups[count++]);
    return count;
}

int draw_groups(const Ui& ui, Rect at, std::span<const KeyGroup> groups) {
    const int row = ui.em(kRow);
    for (const KeyGroup& group : groups) {
        draw_text(ui, static_cast<float>(at.x), static_cast<float>(at.y) + 0.5F * ui.scale.em(kRow),
                  FontRole::kTableStrong, ui.theme.accent_text, group.name);
        at.y += row;
        for (const KeyBinding* key : group.keys) {
            const Rect line{at.x, at.y, at.width, row};
            draw_text(ui, static_cast<float>(line.x), middle_of(line), FontRole::kTable,
                      ui.theme.text, key->label);
            draw_key_cap(ui, static_cast<float>(line.right()), middle_of(line), key->key,
                         ui.theme.text_second);
            at.y += row;
        }
        at.y += ui.em(0.86F);
    }
    return at.y;
}

}  // namespace

void draw_keys_overlay(const Ui& ui, const Rect& screen, const Snapshot& snapshot,
                       KeysOverlayState& local, Requests& out) {
    const auto all = key_groups(snapshot.keys);
    const std::size_t split = in_first_column(all);
    int left_rows = 0;
    int right_rows = 0;
    for (std::size_t i = 0; i < all.size(); ++i) {
        (i < split ? left_rows : right_rows) += rows_of(all[i]);
    }
    DialogFrame frame(ui, screen,
                      {.id = "dialog.keys",
                       .title = "Keys",
                       .width_em = 46.0F,
                       .body_height = ui.em(5.0F) + std::max(left_rows, right_rows) * ui.em(kRow)});
    if (frame.appeared()) local.search.clear();
    Form form(ui, frame.body());
    (void)text_input(ui, form.row({}),
                     {.id = "keys.search",
                      .label = "Search",
                      .placeholder = "what it does, or the key",
                      .icon = Icon::kMagnify,
                      .take_keyboard = frame.appeared()},
                     local.search);
    const auto groups = key_groups(snapshot.keys, local.search);
    const std::size_t first = in_first_column(groups);
    const int gap = ui.em(2.86F);
    const int half = (form.body.width - gap) / 2;
    const std::span<const KeyGroup> span(groups);
    const int one = draw_groups(ui, {form.body.x, form.y, half, 0}, span.first(first));
    const int two =
        draw_groups(ui, {form.body.x + half + gap, form.y, half, 0}, span.subspan(first));
    if (groups.empty()) form.words("No key matches.", ui.theme.text_third);
    frame.end_body(std::max({one, two, form.y}));
    draw_text(ui, static_cast<float>(frame.footer().x), middle_of(frame.footer()), FontRole::kSmall,
              ui.theme.text_third, "Keys can be changed in the settings.");
    const std::array<ButtonSpec, 1> buttons{{{.id = "keys.done", .label = "Done", .key = "Enter"}}};
    const auto pressed = dialog_buttons(ui, frame, buttons);
    frame.end();
    if (pressed || frame.closed()) out.push_back(request::Show{Dialog::kNone});
}

}  // namespace gripscan::ui
