// The colourings of the 3D view: names, legends, ranges, and why one is not to be had. Pure.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "ui/theme/colour_by.h"
#include "ui/theme/colour_map.h"
#include "ui/views/scene_parts.h"

namespace gripscan::ui {

/// Values at the ends of a legend, in its unit.
struct LegendRange {
    double from = 0.0;
    double to = 1.0;
    friend bool operator==(const LegendRange&, const LegendRange&) = default;
};

struct Colouring {
    ColourBy by = ColourBy::kImage;
    std::string_view id;           ///< "colour.step"
    std::string_view name;         ///< "Step"
    std::string_view meaning;      ///< "the view that saw the point"
    std::optional<ColourMap> map;  ///< nothing: has no scale
    std::string_view unit;         ///< of the range
    int decimals = 0;
    double per_unit = 1.0;     ///< what the points carry is the value in this unit times this
    bool typed_range = false;  ///< the user may set it
};

/// In the order of the menu; without the two clouds.
[[nodiscard]] const std::vector<Colouring>& colourings();
[[nodiscard]] const Colouring& colouring(ColourBy by);

/// Why the points cannot be coloured so; empty: they can.
[[nodiscard]] std::string why_no_colouring(ColourBy by, const SceneParts& parts);

/// What suits the scene while the user chose nothing.
[[nodiscard]] ColourBy usual_colouring(const SceneParts& parts);

/// The range that suits the points, in the unit of the colouring: whole mm of depth, twice the
/// median residual, from the least views that are kept to the most. From a sample of each cloud.
[[nodiscard]] LegendRange usual_range(ColourBy by, const SceneParts& parts, int min_seen);

}  // namespace gripscan::ui
