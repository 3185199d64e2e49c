// Buttons. One button a window is the next action; a disabled one says why.
#pragma once

#include <string_view>

#include "ui/widgets/ui.h"

namespace gripscan::ui {

enum class ButtonLook {
    kNormal,
    kNext,    ///< the one highlighted action, Space presses it
    kSecond,  ///< second advice
    kStop,    ///< never disabled
    kHold,    ///< moves the robot while held
};

struct ButtonSpec {
    std::string_view id;     ///< stable: "step.capture"
    std::string_view label;  ///< empty: the icon alone, then `tooltip` is its word
    Icon icon = Icon::kNone;
    std::string_view key = {};  ///< hint at the right: "C"
    ButtonLook look = ButtonLook::kNormal;
    std::string_view why_disabled = {};  ///< empty: enabled
    std::string_view tooltip = {};
    bool chosen = false;     ///< a tool that is on
    float held_part = 0.0F;  ///< of kHold: how much of the fill is shown, 0 … 1
};

struct ButtonEvent {
    bool clicked = false;  ///< in this frame, also by keyboard
    bool held = false;     ///< the mouse is down on it
    explicit operator bool() const { return clicked; }
};

[[nodiscard]] ButtonEvent button(const Ui& ui, const Rect& rect, const ButtonSpec& spec);

/// A button without words, in tool groups and bars.
[[nodiscard]] ButtonEvent icon_button(const Ui& ui, const Rect& rect, const ButtonSpec& spec);

/// How the mouse and the keyboard stand to a control.
struct Attention {
    bool hovered = false;
    bool held = false;
    bool focused = false;  ///< by keyboard
};
/// The picture alone: what `button` draws.
void draw_button(const Ui& ui, const Rect& rect, const ButtonSpec& spec,
                 const Attention& attention);

/// A key as a cap, its right end at `right`; returns its left end.
float draw_key_cap(const Ui& ui, float right, float y, std::string_view key, const Colour& colour);

}  // namespace gripscan::ui
