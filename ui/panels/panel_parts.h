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

/// Rows of a dialog: a label, and the place of what it names.
struct Form {
    const Ui& ui;
    Rect body;
    int y;
    float label_em = 6.5F;

    Form(const Ui& the_ui, const Rect& the_body) : ui(the_ui), body(the_body), y(the_body.y) {}
    /// Draws the label; the place is `height_em` high and has room to the right end.
    Rect row(std::string_view label, float height_em = 2.14F);
    /// Wrapped words below what is there; returns nothing but moves on.
    void words(std::string_view text, const Colour& colour, bool under_label = false);
    void gap(float height_em) { y += ui.em(height_em); }
};

}  // namespace gripscan::ui
