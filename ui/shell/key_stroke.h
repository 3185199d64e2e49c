// Keys by the names that scripts use.
#pragma once

#include <imgui.h>

#include <optional>
#include <string>

namespace gripscan::ui {

struct KeyStroke {
    std::optional<ImGuiKey> named;  ///< one that Dear ImGui has a name for
    int number = 0;                 ///< else: of GLFW
    bool control = false;
    unsigned typed = 0;  ///< the character it types; 0: none
};

/// "Space", "Enter", "Esc", "Tab", "Up" …, "F1" … "F12", a letter or digit, each with "Ctrl+" where
/// wanted. Nothing: there is no such key.
[[nodiscard]] std::optional<KeyStroke> key_stroke(const std::string& name);

}  // namespace gripscan::ui
