// Tooltips: what, then why or how it is computed.
#pragma once

#include <string_view>

#include "ui/widgets/ui.h"

namespace gripscan::ui {

struct TooltipText {
    std::string_view title;
    std::string_view value = {};  ///< at the right of the title, as a number
    std::string_view text = {};   ///< wrapped
};

/// The card alone, at a place; returns its height.
int draw_tooltip(const Ui& ui, int x, int y, int width, const TooltipText& text);

/// Beside the mouse while the last item is hovered, disabled or not; nothing for an empty title.
void tooltip(const Ui& ui, const TooltipText& text);

}  // namespace gripscan::ui
