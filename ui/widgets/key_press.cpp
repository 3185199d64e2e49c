#include "ui/widgets/key_press.h"

#include <fmt/format.h>
#include <imgui.h>

#include <array>
#include <utility>

namespace gripscan::ui {
namespace {

constexpr std::array<std::pair<ImGuiKey, const char*>, 14> kNamed{{{ImGuiKey_Tab, "Tab"},
                                                                   {ImGuiKey_LeftArrow, "Left"},
                                                                   {ImGuiKey_RightArrow, "Right"},
                                                                   {ImGuiKey_UpArrow, "Up"},
                                                                   {ImGuiKey_DownArrow, "Down"},
                                                                   {ImGuiKey_PageUp, "Page up"},
                                                                   {ImGuiKey_PageDown, "Page down"},
                                                                   {ImGuiKey_Home, "Home"},
                                                                   {ImGuiKey_End, "End"},
                                                                   {ImGuiKey_Insert, "Insert"},
                                                                   {ImGuiKey_Delete, "Delete"},
                                                                   {ImGuiKey_Space, "Space"},
                                                                   {ImGuiKey_Enter, "Enter"},
                                                                   {ImGuiKey_Escape, "Esc"}}};

// Dear ImGui 1.86 knows few keys by name; the others have GLFW's numbers, which for letters and
// digits are those of ASCII, and F1 … F12 follow each other.
constexpr int kF1 = 290;

std::string plain_key() {
    for (const auto& [key, name] : kNamed) {
        const int index = ImGui::GetKeyIndex(key);
        if (index >= 0 && ImGui::IsKeyPressed(index, false)) return name;
    }
    for (int key = '0'; key <= 'Z'; ++key) {
        const bool known = key <= '9' || key >= 'A';
        if (known && ImGui::IsKeyPressed(key, false)) return {static_cast<char>(key)};
    }
    for (int i = 0; i < 12; ++i) {
        if (ImGui::IsKeyPressed(kF1 + i, false)) return fmt::format("F{}", i + 1);
    }
    return {};
}

}  // namespace

std::string pressed_key() {
    const std::string key = plain_key();
    if (key.empty()) return {};
    const ImGuiIO& io = ImGui::GetIO();
    return std::string(io.KeyCtrl ? "Ctrl " : "") + (io.KeyAlt ? "Alt " : "") +
           (io.KeyShift ? "Shift " : "") + key;
}

}  // namespace gripscan::ui
