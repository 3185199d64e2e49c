#include "ui/widgets/legend.h"

#include <imgui.h>

#include <fmt/format.h>

#include "ui/widgets/draw.h"

namespace gripscan::ui {

void draw_map_bar(const Ui&, const Rect& rect, ColourMap map) {
    constexpr int kParts = 48;
    ImDrawList& list = *ImGui::GetWindowDrawList();
    for (int i = 0; i < kParts; ++i) {
        const std::uint32_t left = map_colour(map, static_cast<double>(i) / kParts).packed();
        const std::uint32_t right = map_colour(map, (i + 1.0) / kParts).packed();
        const int x = rect.x + rect.width * i / kParts;
        const int end = rect.x + rect.width * (i + 1) / kParts;
        list.AddRectFilledMultiColor({static_cast<float>(x), static_cast<float>(rect.y)},
                                     {static_cast<float>(end), static_cast<float>(rect.bottom())},
                                     left, right, right, left);
    }
}

void draw_step_cells(const Ui& ui, const Rect& rect, int steps, int done) {
    const int line = static_cast<int>(ui.scale.line());
    for (int i = 0; i < steps; ++i) {
        const int x = rect.x + rect.width * i / steps;
        const int end = rect.x + rect.width * (i + 1) / steps;
        const Rect cell{x, rect.y, end - x - line, rect.height};
        if (i < done) {
            fill(cell, map_colour(ColourMap::kStep,
                                  steps > 1 ? static_cast<double>(i) / (steps - 1) : 0.0));
        } else {
            outline(cell, ui.theme.line2, ui.scale.line());
        }
    }
}

int legend_height(const Ui& ui) {
    return ui.em(4.14F);
}

void draw_legend(const Ui& ui, const Rect& rect, const LegendText& text, ColourMap map, int steps,
                 int done) {
    const float radius = ui.scale.em(0.36F);
    fill(rect, ui.theme.panel, radius);
    outline(rect, ui.theme.line, ui.scale.line(), radius);
    const int side = ui.em(0.86F);
    const auto left = static_cast<float>(rect.x + side);
    const auto right = static_cast<float>(rect.right() - side);
    const float title_y = static_cast<float>(rect.y) + ui.scale.em(1.0F);
    const float x = draw_text(ui, left, title_y, FontRole::kTableStrong, ui.theme.text, text.title);
    draw_text(ui, x + ui.scale.em(0.57F), title_y, FontRole::kSmall, ui.theme.text_third,
              fitted(ui, FontRole::kSmall, text.meaning, right - x - ui.scale.em(0.57F)));
    const Rect bar{rect.x + side, rect.y + ui.em(1.86F), rect.width - 2 * side, ui.em(0.71F)};
    if (steps > 0) {
        draw_step_cells(ui, bar, steps, done);
    } else {
        draw_map_bar(ui, bar, map);
    }
    const float tick_y = static_cast<float>(bar.bottom()) + ui.scale.em(0.79F);
    draw_text(ui, left, tick_y, FontRole::kNumberCaption, ui.theme.text_second, text.low);
    draw_text(ui, right, tick_y, FontRole::kNumberCaption, ui.theme.text_second, text.high,
              Align::kRight);
    if (steps > 1 && done > 1 && done < steps - 1) {
        draw_text(ui,
                  static_cast<float>(bar.x) + static_cast<float>(bar.width) *
                                                  (static_cast<float>(done) - 0.5F) /
                                                  static_cast<float>(steps),
                  tick_y, FontRole::kNumberCaption, ui.theme.text, fmt::format("{}", done),
                  Align::kCentre);
    }
}

}  // namespace gripscan::ui
