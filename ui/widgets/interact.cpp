#include "ui/widgets/interact.h"

#include <fmt/format.h>
#include <imgui.h>
#include <imgui_internal.h>

#include <algorithm>
#include <cctype>

#include "ui/widgets/draw.h"
#include "ui/widgets/tooltip.h"

namespace gripscan::ui {

bool enter_pressed() {
    return ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Enter), false) ||
           ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_KeyPadEnter), false);
}

bool escape_pressed() {
    return ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Escape), false);
}

bool space_pressed() {
    return ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Space), false) && keyboard_is_free();
}

bool letter_typed(char letter) {
    const ImGuiIO& io = ImGui::GetIO();
    if (io.WantTextInput || io.KeyCtrl || io.KeyAlt) return false;
    const auto lower = static_cast<ImWchar>(std::tolower(static_cast<unsigned char>(letter)));
    return std::any_of(io.InputQueueCharacters.begin(), io.InputQueueCharacters.end(),
                       [&](ImWchar c) { return c < 128 && std::tolower(c) == lower; });
}

bool keyboard_is_free() {
    return GImGui->ActiveId == 0 && (GImGui->NavDisableHighlight || GImGui->NavId == 0);
}

Interaction interact(const Ui& ui, const Rect& rect, std::string_view id, std::string_view label,
                     std::string_view why_disabled, std::string_view tooltip_text) {
    const bool enabled = why_disabled.empty();
    const std::string name(id);
    ui.log.record({name, std::string(label), rect, enabled, std::string(why_disabled)});
    if (rect.empty()) return {};

    Interaction result;
    ImGui::SetCursorScreenPos({static_cast<float>(rect.x), static_cast<float>(rect.y)});
    ImGui::BeginDisabled(!enabled);
    result.event.clicked = ImGui::InvisibleButton(
        name.c_str(), {static_cast<float>(rect.width), static_cast<float>(rect.height)});
    result.event.held = ImGui::IsItemActive();
    result.attention.hovered = ImGui::IsItemHovered();
    result.attention.held = result.event.held;
    result.attention.focused = ImGui::IsItemFocused() && !GImGui->NavDisableHighlight;
    ImGui::EndDisabled();
    if (enabled && result.attention.focused && enter_pressed()) result.event.clicked = true;
    if (!enabled) {
        tooltip(ui, {fmt::format("{} is not possible", label), {}, why_disabled});
    } else if (!tooltip_text.empty()) {
        tooltip(ui, {tooltip_text});
    }
    return result;
}

void draw_focus_ring(const Ui& ui, const Rect& rect, float radius) {
    const float two = ui.scale.px(2.0F);
    const int inner = static_cast<int>(two);
    outline(rect.shrunk(-inner), ui.theme.panel, two, radius + two);
    outline(rect.shrunk(-2 * inner), ui.theme.accent_text, two, radius + 2.0F * two);
}

}  // namespace gripscan::ui
