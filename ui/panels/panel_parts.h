// Small pictures that several pages share: cards, headings, labelled values.
#pragma once

#include <string_view>

#include "ui/widgets/draw.h"
#include "ui/widgets/ui.h"

namespace gripscan::ui {

[[nodiscard]] inline float middle_of(const Rect& rect) {
    return static_cast<float>(rect.y) + 0.5F * static_cast<float>(rect.height);
}

/// A surface with a border.
void draw_card(const Ui& ui, const Rect& rect, const Colour& surface);

/// A line over the whole width at `y`.
void draw_separator(const Ui& ui, int x, int y, int width);

/// Label at the left, number and unit at the right, in a row.
void draw_value_row(const Ui& ui, const Rect& row, std::string_view label, std::string_view value,
                    std::string_view unit = {});

/// A heading of a section; returns the y below it.
int draw_section(const Ui& ui, int x, int y, std::string_view title);

}  // namespace gripscan::ui
