#include "ui/panels/log_list.h"

#include <imgui.h>

#include <algorithm>

#include "ui/views/log_text.h"
#include "ui/widgets/button.h"
#include "ui/widgets/draw.h"
#include "ui/widgets/interact.h"
#include "ui/widgets/notices.h"
#include "ui/widgets/state_shape.h"
#include "ui/widgets/tooltip.h"

namespace gripscan::ui {
namespace {

constexpr float kHeader = 2.14F;
constexpr float kRow = 1.5F;

LogLevel next_level(LogLevel level) {
    switch (level) {
        case LogLevel::kInformation:
            return LogLevel::kWarning;
        case LogLevel::kWarning:
            return LogLevel::kError;
        case LogLevel::kError:
            break;
    }
    return LogLevel::kInformation;
}

float middle_y(const Rect& rect) {
    return static_cast<float>(rect.y) + 0.5F * static_cast<float>(rect.height);
}

void search_field(const Ui& ui, const Rect& rect, LogListState& local) {
    ui.log.record({"log.search_text", "Search the log", rect, true, {}});
    ImFont* font = ui.fonts[FontRole::kTable];
    const float pad = 0.5F * (static_cast<float>(rect.height) - font->FontSize);
    ImGui::PushFont(font);
    ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {ui.scale.em(0.57F), pad});
    ImGui::SetCursorScreenPos({static_cast<float>(rect.x), static_cast<float>(rect.y)});
    ImGui::SetNextItemWidth(static_cast<float>(rect.width));
    ImGui::InputTextWithHint("##log.search_text", "Search", local.search.data(),
                             local.search.size());
    ImGui::PopStyleVar();
    ImGui::PopFont();
}

void draw_header(const Ui& ui, const Rect& rect, const Snapshot& snapshot, LogListState& local,
                 const LogFilter& filter, Requests& out) {
    const float y = middle_y(rect);
    const int side = ui.em(0.86F);
    draw_text(ui, static_cast<float>(rect.x + side), y, FontRole::kPanelTitle, ui.theme.text,
              "Log");
    const int icon = ui.em(1.86F);
    const int top = rect.y + (rect.height - icon) / 2;
    int x = rect.right() - ui.em(0.43F) - icon;
    const bool empty = filtered(snapshot.log, filter).empty();
    if (icon_button(ui, {x, top, icon, icon},
                    {.id = "log.copy",
                     .label = {},
                     .icon = Icon::kCopy,
                     .why_disabled = empty ? "there is no line to copy" : "",
                     .tooltip = "Copy the lines that are shown"})) {
        out.push_back(request::CopyText{log_for_clipboard(snapshot.log, filter), "Log"});
    }
    x -= icon;
    if (icon_button(ui, {x, top, icon, icon},
                    {.id = "log.search",
                     .label = {},
                     .icon = Icon::kMagnify,
                     .tooltip = "Search in code and text",
                     .chosen = local.searching})) {
        local.searching = !local.searching;
        local.search.fill('\0');
    }
    x -= icon;
    if (icon_button(ui, {x, top, icon, icon},
                    {.id = "log.level",
                     .label = {},
                     .icon = Icon::kFilter,
                     .tooltip = "All levels, warnings and errors, errors",
                     .chosen = local.least != LogLevel::kInformation})) {
        local.least = next_level(local.least);
    }
    if (local.searching) {
        const int from = rect.x + ui.em(3.43F);
        const int height = ui.em(1.71F);
        search_field(ui,
                     {from, rect.y + (rect.height - height) / 2, x - from - ui.em(0.29F), height},
                     local);
        return;
    }
    draw_text(ui, static_cast<float>(x) - ui.scale.em(0.29F), y, FontRole::kSmall,
              ui.theme.text_third, word_at_least(local.least), Align::kRight);
}

void draw_line_of(const Ui& ui, const Rect& row, const LogLine& line) {
    const float y = middle_y(row);
    float x = static_cast<float>(row.x) + ui.scale.em(0.86F);
    x = draw_text(ui, x, y, FontRole::kNumberSmall, ui.theme.text_third, clock_text(line.when)) +
        ui.scale.em(1.0F);
    if (line.level == LogLevel::kInformation) {
        draw_icon(ui, x, y, Icon::kInformation, ui.theme.text_third, FontRole::kIconSmall);
    } else {
        draw_state(ui, x, y, state_of(line.level), 0.93F, ui.theme.panel);
    }
    x += ui.scale.em(1.0F);
    const Colour& code = line.level == LogLevel::kInformation
                             ? ui.theme.text_second
                             : colour_of(ui.theme, state_of(line.level));
    x = draw_text(ui, x, y, FontRole::kNumberSmall, code, line.code) + ui.scale.em(0.71F);
    draw_text(ui, x, y, FontRole::kSmall, ui.theme.text,
              fitted(ui, FontRole::kSmall, line.text,
                     static_cast<float>(row.right()) - x - ui.scale.em(0.86F)));
}

void draw_lines(const Ui& ui, const Rect& rect, const Snapshot& snapshot, const LogFilter& filter) {
    const auto shown = filtered(snapshot.log, filter);
    if (shown.empty()) {
        draw_text(
            ui, static_cast<float>(rect.x) + ui.scale.em(0.86F),
            static_cast<float>(rect.y) + ui.scale.em(1.0F), FontRole::kSmall, ui.theme.text_third,
            snapshot.log.empty() ? "Nothing has happened yet." : "No line passes the filter.");
        return;
    }
    ImGui::SetCursorScreenPos({static_cast<float>(rect.x), static_cast<float>(rect.y)});
    ImGui::BeginChild("log.lines",
                      {static_cast<float>(rect.width), static_cast<float>(rect.height)});
    const int row_height = ui.em(kRow);
    const int scrolled = static_cast<int>(ImGui::GetScrollY());
    const bool at_end = ImGui::GetScrollY() >= ImGui::GetScrollMaxY();
    const int count = static_cast<int>(shown.size());
    for (int i = scrolled / row_height; i < count; ++i) {
        const Rect row{rect.x, rect.y + i * row_height - scrolled, rect.width, row_height};
        if (row.y >= rect.bottom()) break;
        const LogLine& line = snapshot.log[shown[static_cast<std::size_t>(i)]];
        draw_line_of(ui, row, line);
        ImGui::SetCursorScreenPos({static_cast<float>(row.x), static_cast<float>(row.y)});
        ImGui::Dummy({static_cast<float>(row.width), static_cast<float>(row.height)});
        tooltip(ui, {line.code, clock_text(line.when), line.text});
    }
    ImGui::SetCursorPos({0.0F, static_cast<float>(count * row_height)});
    ImGui::Dummy({1.0F, 0.0F});
    if (at_end) ImGui::SetScrollHereY(1.0F);
    ImGui::EndChild();
}

}  // namespace

void draw_log_list(const Ui& ui, const Rect& rect, const Snapshot& snapshot, LogListState& local,
                   Requests& out) {
    if (rect.empty()) return;
    const LogFilter filter{local.least, local.search.data()};
    const Rect header{rect.x, rect.y, rect.width, std::min(rect.height, ui.em(kHeader))};
    draw_header(ui, header, snapshot, local, filter, out);
    // Whole rows.
    const int rows = (rect.bottom() - header.bottom()) / ui.em(kRow);
    const Rect lines{rect.x, header.bottom(), rect.width, rows * ui.em(kRow)};
    if (!lines.empty()) draw_lines(ui, lines, snapshot, filter);
}

}  // namespace gripscan::ui
