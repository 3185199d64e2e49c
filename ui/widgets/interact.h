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

/// A disabled control (`why_disabled` not empty) takes nothing and shows the reason.
[[nodiscard]] Interaction interact(const Ui& ui, const Rect& rect, std::string_view id,
                                   std::string_view label, std::string_view why_disabled,
                                   std::string_view tooltip_text);

/// The ring around a control that has the keyboard.
void draw_focus_ring(const Ui& ui, const Rect& rect, float radius);

}  // namespace gripscan::ui
