// Words, icons and lines at places: the small brushes all widgets paint with.
#pragma once

#include <imgui.h>

#include <string>
#include <string_view>

#include "ui/theme/shown_number.h"
#include "ui/widgets/ui.h"

namespace gripscan::ui {

enum class Align { kLeft, kCentre, kRight };

[[nodiscard]] float text_width(const Ui& ui, FontRole role, std::string_view text);

/// One line. `x` is its left end, centre or right end, `y` the middle of its capitals, so that
/// different faces and sizes stand on a common line. Returns the x where it ends.
float draw_text(const Ui& ui, float x, float y, FontRole role, const Colour& colour,
                std::string_view text, Align align = Align::kLeft);

/// The text as it fits, cut with "…" where it is too wide.
[[nodiscard]] std::string fitted(const Ui& ui, FontRole role, std::string_view text, float width);
/// The same, cut in its middle: of a path the end tells most.
[[nodiscard]] std::string fitted_middle(const Ui& ui, FontRole role, std::string_view text,
                                        float width);

/// Centred on a point.
void draw_icon(const Ui& ui, float x, float y, Icon icon, const Colour& colour,
               FontRole size = FontRole::kIcon);

void fill(const Rect& rect, const Colour& colour, float radius = 0.0F);
/// The border lies inside the rectangle.
void outline(const Rect& rect, const Colour& colour, float thickness, float radius = 0.0F);
void dashed_outline(const Ui& ui, const Rect& rect, const Colour& colour, float dash_px,
                    float gap_px);
void draw_line(const Ui& ui, ImVec2 a, ImVec2 b, const Colour& colour, float thickness = 0.0F);
void dashed_line(const Ui& ui, ImVec2 a, ImVec2 b, const Colour& colour, float dash_px,
                 float gap_px);

}  // namespace gripscan::ui
