#include "ui/panels/panel_parts.h"

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

}  // namespace gripscan::ui
