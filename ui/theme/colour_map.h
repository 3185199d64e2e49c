// Colour maps of clouds and images: lightness rises or diverges, so that colour-blind users and
// grey prints can read them.
#pragma once

#include <array>
#include <cstdint>

#include "ui/theme/colour.h"

namespace gripscan::ui {

enum class ColourMap {
    kStep,      ///< which step saw a point
    kSeen,      ///< how many views saw it
    kResidual,  ///< residual or standard deviation; the middle is half the limit
    kDepth,     ///< depth or disparity, near is bright
};

/// t from 0 to 1 (clamped; no number counts as 0).
[[nodiscard]] Colour map_colour(ColourMap map, double t);

/// 256 colours as RGBA bytes: the texture of the map.
[[nodiscard]] std::array<std::uint8_t, 1024> map_bytes(ColourMap map);

}  // namespace gripscan::ui
