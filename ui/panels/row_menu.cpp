#include "ui/panels/row_menu.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <array>

#include "ui/views/row_commands.h"
#include "ui/widgets/button.h"
#include "ui/widgets/draw.h"
#include "ui/widgets/interact.h"
#include "ui/widgets/tooltip.h"

namespace gripscan::ui {
namespace {

constexpr const char* kName = "table.menu";

/// Returns true when it was chosen.
bool draw_item(const Ui& ui, const Rect& row, const RowCommand& item) {
    const std::string why = item.why_not.value_or(std::string());
    const auto [event, attention] = interact(ui, row, item.id, item.label, why, item.tooltip);
    if (attention.hovered && why.empty()) fill(row, ui.theme.hover, ui.scale.em(0.29F));
    draw_text(ui, static_cast<float>(row.x) + ui.scale.em(0.71F),
              static_cast<float>(row.y) + 0.5F * static_cast<float>(row.height), FontRole::kTable,
              why.empty() ? ui.theme.text : ui.theme.text_third, item.label);
    return event.clicked;
}

}  // namespace

void open_row_menu() {
    ImGui::OpenPopup(kName);
}

void draw_row_menu(const Ui& ui, const Snapshot& snapshot, std::size_t row, Requests& out) {
    if (!ImGui::BeginPopup(kName)) return;
    const auto items = row_commands(snapshot, row);
    float words = 0.0F;
    for (const RowCommand& item : items) {
        words = std::max(words, text_width(ui, FontRole::kTable, item.label));
    }
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const int height = ui.row(1.86F);
    const int width = static_cast<int>(words) + 2 * ui.em(0.71F);
    Rect place{static_cast<int>(at.x), static_cast<int>(at.y), width, height};
    for (const RowCommand& item : items) {
        if (draw_item(ui, place, item)) {
            out.push_back(item.request);
            ImGui::CloseCurrentPopup();
        }
        place.y += height;
    }
    ImGui::SetCursorScreenPos(at);
    ImGui::Dummy(
        {static_cast<float>(width), static_cast<float>(height) * static_cast<float>(items.size())});
    ImGui::EndPopup();
}

}  // namespace gripscan::ui
