// The invisible part of every control: it takes the mouse and the keyboard, notes the control in
// the log and shows its tooltip.
#pragma once

#include <string_view>

#include "ui/widgets/button.h"
#include "ui/widgets/ui.h"

namespace gripscan::ui {

struct Interaction {
    ButtonEvent event;
    Attention attention;
};

/// A disabled control (`why_disabled` not empty) takes nothing and shows the reason. Enter presses
/// the one that has the keyboard, as Space does.
[[nodiscard]] Interaction interact(const Ui& ui, const Rect& rect, std::string_view id,
                                   std::string_view label, std::string_view why_disabled,
                                   std::string_view tooltip_text);

// Keys in this frame, pressed anew.
[[nodiscard]] bool enter_pressed();
[[nodiscard]] bool escape_pressed();
/// While no control has the keyboard, which it would press.
[[nodiscard]] bool space_pressed();
/// Either case, while nobody types.
[[nodiscard]] bool letter_typed(char letter);
/// No field is edited and no control is marked.
[[nodiscard]] bool keyboard_is_free();

/// The ring around a control that has the keyboard.
void draw_focus_ring(const Ui& ui, const Rect& rect, float radius);

}  // namespace gripscan::ui
