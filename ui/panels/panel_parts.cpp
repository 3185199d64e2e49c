#include "ui/panels/panel_parts.h"

#include "ui/widgets/rich_text.h"

namespace gripscan::ui {

void draw_card(const Ui& ui, const Rect& rect, const Colour& surface) {
    const float radius = ui.scale.em(0.43F);
    fill(rect, surface, radius);
    outline(rect, ui.theme.line2, ui.scale.line(), radius);
}

void draw_separator(const Ui& ui, int x, int y, int width) {
    fill({x, y, width, static_cast<int>(ui.scale.line())}, ui.theme.line);
}

void draw_value_row(const Ui& ui, const Rect& row, std::string_view label, std::string_view value,
                    std::string_view unit) {
    const float y = middle_of(row);
    draw_text(ui, static_cast<float>(row.x), y, FontRole::kTable, ui.theme.text_second, label);
    auto right = static_cast<float>(row.right());
    if (!unit.empty()) {
        right -= text_width(ui, FontRole::kNumberCaption, unit);
        draw_text(ui, right, y, FontRole::kNumberCaption, ui.theme.text_third, unit);
        right -= ui.scale.em(0.29F);
    }
    const float left =
        static_cast<float>(row.x) + text_width(ui, FontRole::kTable, label) + ui.scale.em(0.57F);
    draw_text(ui, right, y, FontRole::kNumberTable, ui.theme.text,
              fitted(ui, FontRole::kNumberTable, value, right - left), Align::kRight);
}

int draw_section(const Ui& ui, int x, int y, std::string_view title) {
    const int height = ui.em(1.86F);
    draw_text(ui, static_cast<float>(x), static_cast<float>(y) + 0.5F * static_cast<float>(height),
              FontRole::kTextStrong, ui.theme.text, title);
    return y + height;
}

Rect Form::row(std::string_view label, float height_em) {
    const int label_width = label.empty() ? 0 : ui.em(label_em);
    const Rect at{body.x + label_width, y, body.width - label_width, ui.em(height_em)};
    draw_text(ui, static_cast<float>(body.x),
              static_cast<float>(y) + 0.5F * ui.scale.em(std::min(height_em, 2.14F)),
              FontRole::kTable, ui.theme.text_second, label);
    y = at.bottom() + ui.em(0.71F);
    return at;
}

void Form::words(std::string_view text, const Colour& colour, bool under_label) {
    const int left = under_label ? ui.em(label_em) : 0;
    const TextStyle small{FontRole::kTable, FontRole::kNumberTable, 1.5F};
    y += draw_rich_text(ui, body.x + left, y, body.width - left, colour, text, small);
}

}  // namespace gripscan::ui
