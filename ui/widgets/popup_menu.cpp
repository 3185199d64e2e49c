#include "ui/widgets/popup_menu.h"

#include <imgui.h>

#include <algorithm>
#include <string>

#include "ui/widgets/draw.h"
#include "ui/widgets/interact.h"

namespace gripscan::ui {
namespace {

bool draw_item(const Ui& ui, const Rect& row, const MenuItem& item) {
    const auto [event, attention] = interact(ui, row, item.id, item.label, item.why_disabled, {});
    const bool enabled = item.why_disabled.empty();
    if (enabled && (attention.hovered || attention.focused)) {
        fill(row, ui.theme.hover, ui.scale.em(0.21F));
    }
    const float y = static_cast<float>(row.y) + 0.5F * static_cast<float>(row.height);
    const Colour& colour = enabled ? ui.theme.text : ui.theme.text_third;
    draw_icon(ui, static_cast<float>(row.x) + ui.scale.em(1.0F), y, item.icon,
              enabled ? ui.theme.text_second : ui.theme.text_third, FontRole::kIconSmall);
    draw_text(ui, static_cast<float>(row.x) + ui.scale.em(2.0F), y, FontRole::kTable, colour,
              item.label);
    return event.clicked;
}

}  // namespace

void open_menu(std::string_view menu_id) {
    ImGui::OpenPopup(std::string(menu_id).c_str());
}

std::optional<std::size_t> popup_menu(const Ui& ui, std::string_view menu_id,
                                      std::span<const MenuItem> items, bool* is_open) {
    float words = 0.0F;
    for (const MenuItem& item : items) {
        words = std::max(words, text_width(ui, FontRole::kTable, item.label));
    }
    const int pad = ui.em(0.29F);
    const int width = static_cast<int>(words) + ui.em(3.2F);
    const int row = ui.row(2.0F);
    const int height = row * static_cast<int>(items.size());
    ImGui::SetNextWindowSize(
        {static_cast<float>(width + 2 * pad), static_cast<float>(height + 2 * pad)});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {0.0F, 0.0F});
    const bool open = ImGui::BeginPopup(std::string(menu_id).c_str());
    ImGui::PopStyleVar();
    if (is_open != nullptr) *is_open = open;
    if (!open) return std::nullopt;
    const ImVec2 at = ImGui::GetWindowPos();
    std::optional<std::size_t> chosen;
    for (std::size_t i = 0; i < items.size(); ++i) {
        const Rect place{static_cast<int>(at.x) + pad,
                         static_cast<int>(at.y) + pad + row * static_cast<int>(i), width, row};
        if (draw_item(ui, place, items[i])) chosen = i;
    }
    if (chosen) ImGui::CloseCurrentPopup();
    ImGui::EndPopup();
    return chosen;
}

}  // namespace gripscan::ui
