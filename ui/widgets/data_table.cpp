#include "ui/widgets/data_table.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "ui/widgets/interact.h"

namespace gripscan::ui {
namespace {

constexpr float kRow = 1.71F;
constexpr float kHeader = 1.86F;
constexpr float kGroups = 1.43F;

struct Placed {
    std::size_t index;
    int x;
    int width;
    bool begins_group;
};

std::vector<Placed> place(const Ui& ui, const Rect& rect, std::span<const TableColumn> columns) {
    const auto shown =
        columns_with_room(columns, static_cast<float>(rect.width) / ui.scale.factor());
    int fixed = 0;
    for (const std::size_t i : shown) {
        if (!columns[i].fills) fixed += ui.px(columns[i].width_px);
    }
    std::vector<Placed> placed;
    int x = rect.x;
    for (std::size_t k = 0; k < shown.size(); ++k) {
        const TableColumn& column = columns[shown[k]];
        const int width = column.fills ? std::max(0, rect.width - fixed) : ui.px(column.width_px);
        const bool begins = k > 0 && column.group != columns[shown[k - 1]].group;
        placed.push_back({shown[k], x, width, begins});
        x += width;
    }
    return placed;
}

const Colour& colour_of(const Theme& theme, Tone tone) {
    switch (tone) {
        case Tone::kSecond:
            return theme.text_second;
        case Tone::kThird:
            return theme.text_third;
        case Tone::kCheck:
            return theme.check;
        case Tone::kReject:
            return theme.reject;
        case Tone::kNormal:
        case Tone::kStrong:
            break;
    }
    return theme.text;
}

void draw_error_bar(const Ui& ui, int x, float y, double part, const Colour& colour) {
    const int half = ui.px(20);
    const int height = ui.px(6);
    const int width = static_cast<int>(std::round(std::min(1.0, std::abs(part)) * half));
    const int top = static_cast<int>(y) - height / 2;
    fill({part < 0.0 ? x - width : x, top, width, height}, colour);
    fill({x, top - ui.px(2), static_cast<int>(ui.scale.line()), height + ui.px(4)},
         ui.theme.text_third);
}

void draw_cell(const Ui& ui, const Placed& at, float y, const TableColumn& column,
               const TableCell& cell) {
    const Colour& colour = colour_of(ui.theme, cell.tone);
    const float pad = ui.scale.em(0.57F);
    const float right = static_cast<float>(at.x + at.width) - pad;
    if (cell.bar) {
        const Colour& bar = cell.tone == Tone::kNormal ? ui.theme.accent_text : colour;
        draw_error_bar(ui, at.x + ui.em(2.43F), y, *cell.bar, bar);
    }
    if (!column.words && cell.tone == Tone::kStrong) {  // the name of a row, as wide as it is
        draw_text(ui, static_cast<float>(at.x) + ui.scale.em(0.86F), y, FontRole::kTableStrong,
                  colour, cell.text);
        return;
    }
    if (!column.words) {
        draw_text(ui, right, y, FontRole::kNumberTable, colour, cell.text, Align::kRight);
        return;
    }
    float x = static_cast<float>(at.x) + pad;
    if (cell.shape) {
        draw_state(ui, x + 0.5F * ui.scale.em(0.93F), y, *cell.shape, 0.93F, ui.theme.panel);
        x += ui.scale.em(1.36F);
    }
    const FontRole role = cell.tone == Tone::kStrong ? FontRole::kTableStrong : FontRole::kTable;
    const Colour& words = cell.shape ? colour_of(ui.theme, *cell.shape) : colour;
    x = draw_text(ui, x, y, role, words, fitted(ui, role, cell.text, right - x));
    if (cell.note.empty()) return;
    x += ui.scale.em(0.57F);
    draw_text(ui, x, y, FontRole::kTable, ui.theme.text_second,
              fitted(ui, FontRole::kTable, cell.note, right - x));
}

void draw_row(const Ui& ui, const Rect& row, std::span<const Placed> placed, const TableSpec& spec,
              const TableRow& content) {
    const float y = static_cast<float>(row.y) + 0.5F * static_cast<float>(row.height);
    for (const Placed& at : placed) {
        if (at.index < content.cells.size()) {
            draw_cell(ui, at, y, spec.columns[at.index], content.cells[at.index]);
        }
    }
}

void draw_header(const Ui& ui, const Rect& rect, std::span<const Placed> placed,
                 const TableSpec& spec) {
    const float group_y = static_cast<float>(rect.y) + 0.5F * ui.scale.em(kGroups);
    const float title_y = static_cast<float>(rect.bottom()) - 0.5F * ui.scale.em(kHeader);
    const float pad = ui.scale.em(0.57F);
    for (std::size_t k = 0; k < placed.size(); ++k) {
        const Placed& at = placed[k];
        const TableColumn& column = spec.columns[at.index];
        if (k == 0 || at.begins_group) {
            std::size_t next = k + 1;
            while (next < placed.size() && !placed[next].begins_group) ++next;
            const int end = next < placed.size() ? placed[next].x : rect.right();
            draw_text(ui, static_cast<float>(at.x) + pad, group_y, FontRole::kCaption,
                      ui.theme.text_third,
                      fitted(ui, FontRole::kCaption, column.group,
                             static_cast<float>(end - at.x) - 1.5F * pad));
        }
        draw_text(
            ui,
            static_cast<float>(column.words ? at.x : at.x + at.width) + (column.words ? pad : -pad),
            title_y, FontRole::kCaption, ui.theme.text_second, column.title,
            column.words ? Align::kLeft : Align::kRight);
    }
    const int line = static_cast<int>(ui.scale.line());
    fill({rect.x, rect.bottom() - line, rect.width, line}, ui.theme.line);
}

void draw_group_lines(const Ui& ui, std::span<const Placed> placed, int top, int bottom) {
    const int line = static_cast<int>(ui.scale.line());
    for (const Placed& at : placed) {
        if (at.begins_group) fill({at.x, top, line, bottom - top}, ui.theme.line);
    }
}

void draw_row_background(const Ui& ui, const Rect& row, std::size_t index, const TableSpec& spec,
                         bool hovered) {
    const TableRow& content = spec.rows[index];
    const bool selected = spec.selected == index;
    if (content.tint && *content.tint == State::kReject) {
        fill(row, ui.theme.reject_bg);
        fill({row.x, row.y, ui.px(3), row.height}, ui.theme.reject);
    } else if (selected) {
        fill(row, ui.theme.select);
        fill({row.x, row.y, ui.px(3), row.height}, ui.theme.accent);
    } else if (hovered) {
        fill(row, ui.theme.raised);
    } else if (index % 2 == 1) {
        fill(row, ui.theme.text_third.with_alpha(0.045));
    }
    const int line = static_cast<int>(ui.scale.line());
    fill({row.x, row.bottom() - line, row.width, line}, ui.theme.line);
}

/// Only rows that can be seen are drawn.
TableEvent draw_rows(const Ui& ui, const Rect& area, std::span<const Placed> placed,
                     const TableSpec& spec, int row_height) {
    TableEvent event;
    const int count = static_cast<int>(spec.rows.size());
    const float scrolled = ImGui::GetScrollY();
    const int first = std::max(0, static_cast<int>(scrolled) / row_height);
    const int end = std::min(count, first + area.height / row_height + 2);
    for (int i = first; i < end; ++i) {
        const auto index = static_cast<std::size_t>(i);
        const Rect row{area.x, area.y + i * row_height - static_cast<int>(scrolled), area.width,
                       row_height};
        const auto [pressed, attention] =
            interact(ui, row, fmt::format("{}.row{}", spec.id, i), {}, {}, {});
        if (pressed.clicked) event.clicked = index;
        if (ImGui::IsItemClicked(ImGuiMouseButton_Right)) event.menu = index;
        draw_row_background(ui, row, index, spec, attention.hovered);
        draw_row(ui, row, placed, spec, spec.rows[index]);
    }
    ImGui::SetCursorPos({0.0F, static_cast<float>(count * row_height)});
    ImGui::Dummy({1.0F, 0.0F});
    return event;
}

}  // namespace

std::vector<std::size_t> columns_with_room(std::span<const TableColumn> columns, float width_px) {
    std::vector<std::size_t> shown(columns.size());
    float needed = 0.0F;
    for (std::size_t i = 0; i < columns.size(); ++i) {
        shown[i] = i;
        needed += columns[i].width_px;
    }
    while (needed > width_px) {
        const auto first_to_go =
            std::min_element(shown.begin(), shown.end(), [&](std::size_t a, std::size_t b) {
                const auto order = [&](std::size_t i) {
                    return columns[i].drop > 0 ? columns[i].drop : 1000000;
                };
                return order(a) < order(b);
            });
        if (first_to_go == shown.end() || columns[*first_to_go].drop <= 0) break;
        needed -= columns[*first_to_go].width_px;
        shown.erase(first_to_go);
    }
    return shown;
}

TableEvent data_table(const Ui& ui, const Rect& rect, const TableSpec& spec) {
    const int row_height = ui.row(kRow);
    const int bar = ui.px(9);
    const auto placed = place(ui, {rect.x, rect.y, rect.width - bar, rect.height}, spec.columns);
    const bool grouped = std::any_of(spec.columns.begin(), spec.columns.end(),
                                     [](const TableColumn& c) { return !c.group.empty(); });
    const Rect header{rect.x, rect.y, rect.width,
                      std::min(rect.height, ui.em(grouped ? kGroups + kHeader : kHeader))};
    const int last_height = row_height * static_cast<int>(spec.last_rows.size());
    const Rect area{rect.x, header.bottom(), rect.width,
                    std::max(0, rect.height - header.height - last_height)};
    draw_header(ui, header, placed, spec);

    TableEvent event;
    if (!area.empty()) {
        ImGui::SetCursorScreenPos({static_cast<float>(area.x), static_cast<float>(area.y)});
        ImGui::BeginChild(std::string(spec.id).c_str(),
                          {static_cast<float>(area.width), static_cast<float>(area.height)});
        event = draw_rows(ui, area, placed, spec, row_height);
        draw_group_lines(ui, placed, area.y, area.bottom());
        const bool at_end = ImGui::GetScrollY() >= ImGui::GetScrollMaxY();
        if (spec.follow_end && !at_end && !ImGui::IsWindowHovered()) ImGui::SetScrollHereY(1.0F);
        ImGui::EndChild();
    }
    int y = area.bottom();
    const int line = static_cast<int>(ui.scale.line());
    for (const TableRow& row : spec.last_rows) {
        const Rect last{rect.x, y, rect.width, row_height};
        fill(last, ui.theme.raised);
        fill({last.x, last.y, last.width, y == area.bottom() ? 2 * line : line}, ui.theme.line2);
        draw_row(ui, last, placed, spec, row);
        y += row_height;
    }
    draw_group_lines(ui, placed, area.bottom(), y);
    return event;
}

}  // namespace gripscan::ui
