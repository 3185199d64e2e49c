// Sentences with numbers in them. Numbers stand between back quotes: "error `−0.021`° is inside".
#pragma once

#include <string_view>

#include "ui/widgets/ui.h"

namespace gripscan::ui {

struct TextStyle {
    FontRole words = FontRole::kText;
    FontRole numbers = FontRole::kNumber;
    float line_em = 1.5F;
};

/// Wraps at blanks; returns the height it took. Units that follow a number stay with it.
int draw_rich_text(const Ui& ui, int x, int y, int width, const Colour& colour,
                   std::string_view text, const TextStyle& style = {});
/// The height alone.
[[nodiscard]] int rich_text_height(const Ui& ui, int width, std::string_view text,
                                   const TextStyle& style = {});

}  // namespace gripscan::ui
