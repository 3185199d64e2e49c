#include "ui/widgets/key_press.h"

#include <fmt/format.h>
#include <imgui.h>

#include <array>
#include <cctype>
#include <utility>

namespace gripscan::ui {
namespace {

constexpr int kF1 = 290;  ///< as the window numbers its keys; F2 … F12 follow

bool went_down(int number) {
    return ImGui::IsKeyPressed(number, false);
}

bool anything_went_down() {
    for (const float held_s : ImGui::GetIO().KeysDownDuration) {
        if (held_s == 0.0F) return true;
    }
    return false;
}

/// What was typed: the letter that stands on the key, whatever the layout. A key that repeats
/// itself types again but did not go down again.
void add_typed(std::vector<std::string>& keys) {
    if (!anything_went_down()) return;
    for (const ImWchar c : ImGui::GetIO().InputQueueCharacters) {
        if (c == ' ') {
            keys.emplace_back("Space");
        } else if (c > ' ' && c < 0x7F) {
            keys.emplace_back(1, static_cast<char>(std::toupper(static_cast<int>(c))));
        }
    }
}

/// With Ctrl nothing is typed. Letters and digits have the number of their character.
void add_with_ctrl(std::vector<std::string>& keys) {
    for (const auto& [first, last] : {std::pair('0', '9'), std::pair('A', 'Z')}) {
        for (char c = first; c <= last; ++c) {
            if (went_down(c)) keys.push_back(fmt::format("Ctrl+{}", c));
        }
    }
    constexpr std::array<std::pair<int, char>, 5> kSigns{
        {{'=', '+'}, {334, '+'}, {'-', '-'}, {333, '-'}, {',', ','}}};
    for (const auto& [number, sign] : kSigns) {
        if (went_down(number)) keys.push_back(fmt::format("Ctrl+{}", sign));
    }
}

void add_named(std::vector<std::string>& keys) {
    constexpr std::array<std::pair<ImGuiKey, const char*>, 5> kNamed{
        {{ImGuiKey_Enter, "Enter"},
         {ImGuiKey_Delete, "Delete"},
         {ImGuiKey_Home, "Home"},
         {ImGuiKey_UpArrow, "Up"},
         {ImGuiKey_DownArrow, "Down"}}};
    const std::string modifier = ImGui::GetIO().KeyCtrl ? "Ctrl+" : "";
    // Stop is Esc, whatever else is held.
    if (went_down(ImGui::GetKeyIndex(ImGuiKey_Escape))) keys.emplace_back("Esc");
    for (const auto& [key, name] : kNamed) {
        if (went_down(ImGui::GetKeyIndex(key))) keys.push_back(modifier + name);
    }
    for (int i = 0; i < 12; ++i) {
        if (went_down(kF1 + i)) keys.push_back(fmt::format("F{}", i + 1));
    }
}

}  // namespace

std::vector<std::string> pressed_keys() {
    std::vector<std::string> keys;
    if (ImGui::GetIO().KeyCtrl) {
        add_with_ctrl(keys);
    } else {
        add_typed(keys);
    }
    add_named(keys);
    return keys;
}

std::vector<std::string> command_keys() {
    const bool menu =
        ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopupId | ImGuiPopupFlags_AnyPopupLevel);
    if (ImGui::GetIO().WantTextInput || menu) return {};
    return pressed_keys();
}

}  // namespace gripscan::ui
