#include "ui/panels/table_dock.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <array>

#include "ui/panels/action_button.h"
#include "ui/panels/row_menu.h"
#include "ui/panels/step_images.h"
#include "ui/panels/text_table.h"
#include "ui/views/log_text.h"
#include "ui/widgets/choice.h"
#include "ui/widgets/data_table.h"
#include "ui/widgets/draw.h"

namespace gripscan::ui {
namespace {

constexpr float kHeader = 2.43F;

void table_tab(const Ui& ui, const Rect& rect, const Snapshot& snapshot, TableDockState& local,
               Requests& out) {
    if (snapshot.procedure == nullptr) return;
    const TableText text = table_text(snapshot, local.view);
    const std::size_t steps = table_of(*snapshot.procedure).size();
    std::optional<std::size_t> selected;
    if (steps > 0) {
        selected = snapshot.follows_last ? steps - 1 : std::min(snapshot.selected_row, steps - 1);
    }
    const TableEvent event =
        draw_text_table(ui, rect, "table", text, selected, snapshot.follows_last);
    const auto is_step = [&](const std::optional<std::size_t>& row) { return row && *row < steps; };
    if (is_step(event.clicked)) {
        const bool last = *event.clicked + 1 == steps;
        out.push_back(request::SelectStep{last ? std::nullopt : event.clicked});
    }
    if (is_step(event.menu)) {
        out.push_back(request::SelectStep{event.menu});
        local.menu_row = event.menu;
        open_row_menu();
    }
    if (local.menu_row && *local.menu_row < steps) {
        draw_row_menu(ui, snapshot, *local.menu_row, out);
    }
    if (steps == 0 && text.rows.empty()) {
        draw_text(ui, static_cast<float>(rect.x) + 0.5F * static_cast<float>(rect.width),
                  static_cast<float>(rect.y) + 0.5F * static_cast<float>(rect.height),
                  FontRole::kTable, ui.theme.text_third,
                  "Every step is one row: the robot's angle against that of the scans.",
                  Align::kCentre);
    }
}

/// Switch and buttons at the right of the header; what has no room is left out.
void draw_table_tools(const Ui& ui, const Rect& header, int left, const Snapshot& snapshot,
                      TableDockState& local, Requests& out) {
    const int side = ui.em(2.0F);
    const int y = header.y + (header.height - side) / 2;
    int x = header.right() - ui.em(0.57F);
    x -= side;
    action_icon(ui, {x, y, side, side}, action("table.csv"), snapshot, out);
    x -= side;
    action_icon(ui, {x, y, side, side}, action("table.copy"), snapshot, out);
    if (local.tab != DockTab::kTable) return;
    const int width = ui.em(20.0F);
    const int height = ui.em(1.86F);
    x -= width + ui.em(0.57F);
    if (x < left + ui.em(0.57F)) return;
    const std::array<Option, 2> views{
        {{"table.against", "Robot against ICP"}, {"table.pose", "Roll pitch yaw X Y Z"}}};
    const auto clicked = segments(ui, {x, header.y + (header.height - height) / 2, width, height},
                                  views, static_cast<std::size_t>(local.view));
    if (clicked) local.view = static_cast<TableView>(*clicked);
}

/// Returns where they end.
int draw_tabs(const Ui& ui, const Rect& header, const Snapshot& snapshot, const Detail& detail,
              TableDockState& local) {
    const std::size_t attempts =
        snapshot.procedure == nullptr ? 0 : snapshot.procedure->data.captures.size();
    const std::string count = attempts == 0 ? std::string() : fmt::format("{}", attempts);
    std::vector<Option> options{{"dock.table", "Table 1", Icon::kTable},
                                {"dock.images", "Step images", Icon::kImages},
                                {"dock.attempts", "Attempts", Icon::kHistory, count}};
    if (detail.log_is_a_tab) options.push_back({"dock.log", "Log", Icon::kInformation});
    if (!detail.log_is_a_tab && local.tab == DockTab::kLog) local.tab = DockTab::kTable;
    const Rect rect{header.x, header.y, header.width, header.height};
    if (const auto clicked = tabs(ui, rect, options, static_cast<std::size_t>(local.tab))) {
        local.tab = static_cast<DockTab>(*clicked);
    }
    int end = ui.log.find(options.back().id)->rect.right();
    if (detail.log_is_a_tab && worst_of(snapshot.log) != LogLevel::kInformation) {
        draw_state(ui, static_cast<float>(end), static_cast<float>(header.y + header.height / 2),
                   state_of(worst_of(snapshot.log)), 0.93F, ui.theme.panel);
        end += ui.em(1.0F);
    }
    return end;
}

}  // namespace

void draw_table_dock(const Ui& ui, const Rect& rect, const Snapshot& snapshot, const Detail& detail,
                     TableDockState& local, LogListState& log, PictureCache* pictures,
                     Requests& out) {
    fill(rect, ui.theme.panel);
    const Rect header{rect.x, rect.y, rect.width, std::min(rect.height, ui.em(kHeader))};
    const int tabs_end = draw_tabs(ui, header, snapshot, detail, local);
    draw_table_tools(ui, header, tabs_end, snapshot, local, out);
    const int line = static_cast<int>(ui.scale.line());
    fill({rect.x, header.bottom() - line, rect.width, line}, ui.theme.line);
    const Rect area{rect.x, header.bottom(), rect.width, rect.height - header.height};
    if (area.height < ui.em(3.0F)) return;
    switch (local.tab) {
        case DockTab::kTable:
            return table_tab(ui, area, snapshot, local, out);
        case DockTab::kImages:
            return draw_step_images(ui, area, snapshot, pictures);
        case DockTab::kAttempts:
            (void)draw_text_table(ui, area, "attempts", attempts_text(snapshot), std::nullopt,
                                  true);
            return;
        case DockTab::kLog:
            return draw_log_list(ui, area, snapshot, log, out);
    }
}

}  // namespace gripscan::ui
