// A part of a picture: how the 3D view is cut from a photograph of the window.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "ui/layout/rect.h"

namespace gripscan::ui {

/// RGBA rows from top to bottom. What of `part` lies outside the picture is left out; `part`
/// becomes what was cut.
[[nodiscard]] std::vector<std::uint8_t> cropped_rgba(std::span<const std::uint8_t> rgba,
                                                     int width_px, int height_px, Rect& part);

}  // namespace gripscan::ui
