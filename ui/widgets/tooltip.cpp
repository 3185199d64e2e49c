#include "ui/widgets/tooltip.h"

#include <imgui.h>

#include "ui/widgets/draw.h"
#include "ui/widgets/rich_text.h"

namespace gripscan::ui {
namespace {

constexpr TextStyle kStyle{FontRole::kSmall, FontRole::kNumberSmall, 1.45F};

int card_height(const Ui& ui, int width, const TooltipText& text) {
    int height = 2 * ui.em(0.71F) + ui.em(1.29F);
    if (!text.text.empty()) {
        height += rich_text_height(ui, width - 2 * ui.em(0.86F), text.text, kStyle);
    }
    return height;
}

}  // namespace

int draw_tooltip(const Ui& ui, int x, int y, int width, const TooltipText& text) {
    const int height = card_height(ui, width, text);
    const Rect card{x, y, width, height};
    const float radius = ui.scale.em(0.36F);
    fill(card, ui.theme.panel, radius);
    outline(card, ui.theme.line2, ui.scale.line(), radius);
    const int side = ui.em(0.86F);
    const auto title_y = static_cast<float>(y + ui.em(0.71F) + ui.em(0.64F));
    draw_text(ui, static_cast<float>(x + side), title_y, FontRole::kPanelTitle, ui.theme.text,
              text.title);
    draw_text(ui, static_cast<float>(x + width - side), title_y, FontRole::kNumberTable,
              ui.theme.text, text.value, Align::kRight);
    if (!text.text.empty()) {
        draw_rich_text(ui, x + side, y + ui.em(0.71F) + ui.em(1.29F), width - 2 * side,
                       ui.theme.text_second, text.text, kStyle);
    }
    return height;
}

void tooltip(const Ui& ui, const TooltipText& text) {
    if (text.title.empty() || !ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled)) {
        return;
    }
    const int widest = ui.em(23.0F);
    const float wanted = std::max(text_width(ui, FontRole::kPanelTitle, text.title) +
                                      text_width(ui, FontRole::kNumberTable, text.value) + 28.0F,
                                  text_width(ui, FontRole::kSmall, text.text)) +
                         2.0F * ui.scale.em(0.86F);
    // A long title alone makes it wider than a text would.
    const float title = text_width(ui, FontRole::kPanelTitle, text.title) +
                        2.0F * ui.scale.em(0.86F) + 28.0F;
    const int width = std::max(std::min(widest, static_cast<int>(wanted) + 1),
                               text.value.empty() ? static_cast<int>(title) : 0);
    const ImVec2 screen = ImGui::GetIO().DisplaySize;
    const ImVec2 mouse = ImGui::GetMousePos();
    // Beside the mouse, and inside the window.
    const float room_x = screen.x - static_cast<float>(width) - ui.scale.em(1.5F);
    ImGui::SetNextWindowPos({std::max(0.0F, std::min(mouse.x + ui.scale.em(1.0F), room_x)),
                             mouse.y + ui.scale.em(1.4F)});
    ImGui::BeginTooltip();
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const int height =
        draw_tooltip(ui, static_cast<int>(at.x), static_cast<int>(at.y), width, text);
    ImGui::Dummy({static_cast<float>(width), static_cast<float>(height)});
    ImGui::EndTooltip();
}

}  // namespace gripscan::ui
