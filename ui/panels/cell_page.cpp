#include "ui/panels/cell_page.h"

#include <fmt/format.h>

#include <array>

#include "core/base/units.h"
#include "core/procedure/step.h"
#include "ui/panels/cell_column.h"
#include "ui/panels/panel_parts.h"
#include "ui/views/cell_view.h"
#include "ui/widgets/button.h"
#include "ui/widgets/data_table.h"
#include "ui/widgets/rich_text.h"

namespace gripscan::ui {
namespace {

State state_of(CheckOutcome outcome) {
    switch (outcome) {
        case CheckOutcome::kPassed:
            return State::kAccept;
        case CheckOutcome::kWarned:
            return State::kCheck;
        case CheckOutcome::kFailed:
            return State::kReject;
        case CheckOutcome::kSkipped:
            break;
    }
    return State::kWaiting;
}

Tone tone_of(CheckOutcome outcome) {
    return outcome == CheckOutcome::kFailed   ? Tone::kReject
           : outcome == CheckOutcome::kWarned ? Tone::kCheck
                                              : Tone::kNormal;
}

std::vector<TableRow> rows_of(const CellReport& report) {
    std::vector<TableRow> rows;
    for (const CellCheckItem& item : report.items) {
        TableRow row;
        TableCell outcome{std::string(word(item.outcome))};
        outcome.shape = state_of(item.outcome);
        row.cells = {{item.name, Tone::kStrong},
                     outcome,
                     {check_number(item, item.value), tone_of(item.outcome)},
                     {limit_text(item), Tone::kThird},
                     {item.unit, Tone::kThird},
                     {item.sentence, Tone::kSecond}};
        if (item.outcome == CheckOutcome::kFailed) row.tint = State::kReject;
        rows.push_back(std::move(row));
    }
    return rows;
}

/// Why a command of the check cannot be given; empty: it can.
std::string why_not(const Snapshot& snapshot, const Command& command) {
    if (snapshot.procedure == nullptr) return "No session is open.";
    if (snapshot.session && snapshot.session->recorded) return "A recording is only looked at.";
    return refusal(*snapshot.procedure, command).value_or("");
}

/// Room for the words beside the buttons; else the buttons stand below them.
bool head_in_one_row(const Ui& ui, int width) {
    return width >= ui.em(52.0F);
}

int head_height(const Ui& ui, int width) {
    const int buttons = ui.row(2.57F) + 2 * ui.em(0.86F);
    return head_in_one_row(ui, width) ? buttons : buttons + ui.em(2.57F);
}

/// Returns where the buttons begin.
int draw_head_buttons(const Ui& ui, const Rect& row, const Snapshot& snapshot, bool accepts,
                      Requests& out) {
    const bool first = snapshot.procedure == nullptr || !snapshot.procedure->cell;
    const std::string why = why_not(snapshot, command::CheckCell{});
    const Rect check{row.right() - ui.em(11.0F), row.y, ui.em(11.0F), row.height};
    if (button(ui, check,
               {.id = "cell.check",
                .label = first ? "Check the cell" : "Check again",
                .icon = first ? Icon::kCheck : Icon::kRetry,
                .look = first || accepts ? ButtonLook::kNext : ButtonLook::kNormal,
                .why_disabled = why})) {
        out.push_back(request::Give{command::CheckCell{}});
    }
    if (!accepts) return check.x;
    const std::string why_accept = why_not(snapshot, command::Accept{"a note"});
    const Rect accept{check.x - ui.em(0.57F) - ui.em(11.0F), row.y, ui.em(11.0F), row.height};
    if (button(ui, accept,
               {.id = "cell.accept", .label = "Accept with note…", .why_disabled = why_accept})) {
        out.push_back(request::Show{Dialog::kNote});
    }
    return accept.x;
}

void draw_head(const Ui& ui, const Rect& head, const Snapshot& snapshot, Requests& out) {
    const CheckSummary summary = check_summary(snapshot.procedure);
    const int height = ui.row(2.57F);
    const Rect buttons{head.x, head.bottom() - height - ui.em(0.86F), head.width, height};
    const int begin = draw_head_buttons(ui, buttons, snapshot, summary.can_be_accepted, out);
    const bool one_row = head_in_one_row(ui, head.width);
    const float y = one_row ? middle_of(buttons) : static_cast<float>(head.y) + ui.scale.em(1.7F);
    const int right = one_row ? begin - ui.em(0.86F) : head.right();
    float x = draw_text(ui, static_cast<float>(head.x), y, FontRole::kTitle, ui.theme.text,
                        "Cell check") +
              ui.scale.em(1.6F);
    const State state = state_of(summary.outcome);
    draw_state(ui, x, y, state, 1.14F, ui.theme.panel);
    x += ui.scale.em(1.0F);
    draw_text(ui, x, y, FontRole::kText, colour_of(ui.theme, state),
              fitted(ui, FontRole::kText, summary.words, static_cast<float>(right) - x));
}

void draw_unchecked(const Ui& ui, const Rect& area, const Snapshot& snapshot) {
    const float x = static_cast<float>(area.x) + 0.5F * static_cast<float>(area.width);
    const float y = middle_of(area);
    const bool busy = snapshot.procedure != nullptr &&
                      std::holds_alternative<phase::Busy>(snapshot.procedure->phase);
    draw_state(ui, x, y - ui.scale.em(2.2F), busy ? State::kRunning : State::kWaiting, 1.43F,
               ui.theme.panel);
    draw_text(ui, x, y, FontRole::kTextStrong, ui.theme.text_second,
              busy ? "The cell is being checked" : "Nothing is measured yet", Align::kCentre);
    const float room = static_cast<float>(area.width) - ui.scale.em(2.0F);
    draw_text(ui, x, y + ui.scale.em(1.5F), FontRole::kSmall, ui.theme.text_third,
              fitted(ui, FontRole::kSmall,
                     "Link, joints, range, volume, light, texture, room to turn, disk and time "
                     "are measured against limits.",
                     room),
              Align::kCentre);
}

/// The whole sentence of the selected item, below the table.
void draw_sentence(const Ui& ui, const Rect& area, const CellCheckItem& item) {
    fill(area, ui.theme.raised, ui.scale.em(0.36F));
    const float y = static_cast<float>(area.y) + ui.scale.em(1.3F);
    const State state = state_of(item.outcome);
    draw_state(ui, static_cast<float>(area.x) + ui.scale.em(1.4F), y, state, 1.14F,
               ui.theme.raised);
    draw_text(ui, static_cast<float>(area.x) + ui.scale.em(2.6F), y, FontRole::kTextStrong,
              ui.theme.text, item.name);
    draw_rich_text(ui, area.x + ui.em(2.6F), area.y + ui.em(2.2F), area.width - ui.em(3.6F),
                   ui.theme.text_second, item.sentence,
                   {FontRole::kTable, FontRole::kNumberTable, 1.5F});
}

std::size_t selected_item(const CellReport& report, const CellPageState& local) {
    if (local.selected && *local.selected < report.items.size()) return *local.selected;
    for (std::size_t i = 0; i < report.items.size(); ++i) {
        if (report.items[i].outcome == CheckOutcome::kFailed) return i;
    }
    return 0;
}

void draw_check(const Ui& ui, const Rect& area, const Snapshot& snapshot, CellPageState& local,
                Requests& out) {
    fill(area, ui.theme.panel);
    const int head_width = area.width - 2 * ui.em(1.14F);
    const Rect head{area.x + ui.em(1.14F), area.y, head_width, head_height(ui, head_width)};
    draw_head(ui, head, snapshot, out);
    draw_separator(ui, area.x, head.bottom(), area.width);
    const Rect rest{area.x, head.bottom() + static_cast<int>(ui.scale.line()), area.width,
                    area.bottom() - head.bottom() - static_cast<int>(ui.scale.line())};
    if (snapshot.procedure == nullptr || !snapshot.procedure->cell ||
        snapshot.procedure->cell->items.empty()) {
        draw_unchecked(ui, rest, snapshot);
        return;
    }
    const CellReport& report = *snapshot.procedure->cell;
    const auto rows = rows_of(report);
    const std::array<TableColumn, 6> columns{{{"item", {}, 96, false, true},
                                              {"outcome", {}, 110, false, true},
                                              {"value", {}, 76},
                                              {"limit", {}, 76},
                                              {"unit", {}, 54, false, true},
                                              {"found", {}, 120, true, true, 2}}};
    const int sentence = ui.em(5.6F);
    const std::size_t selected = selected_item(report, local);
    const int wanted = ui.em(1.86F) + ui.row(1.71F) * static_cast<int>(rows.size());
    const int height = std::min(wanted, rest.height - sentence - ui.em(1.14F));
    const Rect table{rest.x + ui.em(0.57F), rest.y, rest.width - ui.em(1.14F), height};
    const auto event = data_table(ui, table, {"cell.items", columns, rows, {}, selected});
    if (event.clicked) local.selected = event.clicked;
    draw_sentence(ui,
                  {rest.x + ui.em(1.14F), table.bottom() + ui.em(0.86F),
                   rest.width - 2 * ui.em(1.14F), sentence - ui.em(0.57F)},
                  report.items[selected]);
}

}  // namespace

void draw_cell_page(const Ui& ui, const Rect& rect, const Snapshot& snapshot, CellPageState& local,
                    Requests& out) {
    fill(rect, ui.theme.bg0);
    const int width = std::min(ui.em(27.14F), rect.width * 45 / 100);
    const int gap = ui.px(4);
    draw_check(ui, {rect.x, rect.y, rect.width - width - gap, rect.height}, snapshot, local, out);
    draw_cell_column(ui, {rect.right() - width, rect.y, width, rect.height}, snapshot, out);
}

}  // namespace gripscan::ui
