// Colour legends: what a colour means, from where to where, in which unit.
#pragma once

#include <string_view>

#include "ui/theme/colour_map.h"
#include "ui/widgets/ui.h"

namespace gripscan::ui {

/// A continuous map in a bar.
void draw_map_bar(const Ui& ui, const Rect& rect, ColourMap map);

/// One cell a step; those to come are empty.
void draw_step_cells(const Ui& ui, const Rect& rect, int steps, int done);

struct LegendText {
    std::string_view title;    ///< "Residual"
    std::string_view meaning;  ///< "distance to the merged surface"
    std::string_view low;      ///< numbers at the ends, the unit with the last
    std::string_view high;
};

/// The card of the 3D view, bottom left; with steps > 0 it has cells.
void draw_legend(const Ui& ui, const Rect& rect, const LegendText& text, ColourMap map,
                 int steps = 0, int done = 0);
[[nodiscard]] int legend_height(const Ui& ui);

}  // namespace gripscan::ui
