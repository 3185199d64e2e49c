#include "ui/panels/pressed_keys.h"

#include <imgui.h>

#include <array>
#include <utility>

namespace gripscan::ui {

std::vector<std::string> pressed_view_keys() {
    const ImGuiIO& io = ImGui::GetIO();
    if (io.WantTextInput ||
        ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopupId | ImGuiPopupFlags_AnyPopupLevel)) {
        return {};
    }
    const std::string modifier = io.KeyCtrl ? "Ctrl+" : "";
    std::vector<std::string> keys;
    // Letters and digits have the number of their character with every backend.
    for (const auto& [first, last] : {std::pair('0', '9'), std::pair('A', 'Z')}) {
        for (char c = first; c <= last; ++c) {
            if (ImGui::IsKeyPressed(c, false)) keys.push_back(modifier + c);
        }
    }
    constexpr std::array<std::pair<ImGuiKey, const char*>, 4> kNamed{
        {{ImGuiKey_Home, "Home"},
         {ImGuiKey_Escape, "Esc"},
         {ImGuiKey_UpArrow, "Up"},
         {ImGuiKey_DownArrow, "Down"}}};
    for (const auto& [key, name] : kNamed) {
        if (ImGui::IsKeyPressed(ImGui::GetKeyIndex(key), false)) keys.push_back(modifier + name);
    }
    return keys;
}

}  // namespace gripscan::ui
