#include "ui/shell/key_stroke.h"

#include <cctype>
#include <map>
#include <string_view>

namespace gripscan::ui {
namespace {

constexpr int kF1 = 290;  // of GLFW; F2 … F12 follow

std::optional<int> function_key(const std::string& name) {
    if (name.size() < 2 || name.size() > 3 || name[0] != 'F') return std::nullopt;
    int number = 0;
    for (const char c : name.substr(1)) {
        if (std::isdigit(static_cast<unsigned char>(c)) == 0) return std::nullopt;
        number = 10 * number + (c - '0');
    }
    if (number < 1 || number > 12) return std::nullopt;
    return kF1 + number - 1;
}

}  // namespace

std::optional<KeyStroke> key_stroke(const std::string& name) {
    static const std::map<std::string, ImGuiKey> kNamed{
        {"Space", ImGuiKey_Space},         {"Enter", ImGuiKey_Enter},
        {"Esc", ImGuiKey_Escape},          {"Tab", ImGuiKey_Tab},
        {"Up", ImGuiKey_UpArrow},          {"Down", ImGuiKey_DownArrow},
        {"Left", ImGuiKey_LeftArrow},      {"Right", ImGuiKey_RightArrow},
        {"Backspace", ImGuiKey_Backspace}, {"Home", ImGuiKey_Home}};
    constexpr std::string_view kControl = "Ctrl+";
    const bool control = name.starts_with(kControl);
    const std::string key = control ? name.substr(kControl.size()) : name;
    if (const auto named = kNamed.find(key); named != kNamed.end()) {
        return KeyStroke{named->second, 0, control, key == "Space" ? ' ' : 0U};
    }
    if (const auto number = function_key(key)) return KeyStroke{std::nullopt, *number, control, 0};
    if (key.size() != 1 || std::isgraph(static_cast<unsigned char>(key[0])) == 0) {
        return std::nullopt;
    }
    // GLFW numbers its printable keys by their upper-case ASCII codes.
    const auto character = static_cast<unsigned char>(key[0]);
    return KeyStroke{std::nullopt, std::toupper(character), control, character};
}

}  // namespace gripscan::ui
