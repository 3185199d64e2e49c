#include "ui/render/picture_crop.h"

#include <algorithm>

namespace gripscan::ui {

std::vector<std::uint8_t> cropped_rgba(std::span<const std::uint8_t> rgba, int width_px,
                                       int height_px, Rect& part) {
    const int left = std::clamp(part.x, 0, width_px);
    const int top = std::clamp(part.y, 0, height_px);
    const int right = std::clamp(part.right(), left, width_px);
    const int bottom = std::clamp(part.bottom(), top, height_px);
    part = {left, top, right - left, bottom - top};
    std::vector<std::uint8_t> pixels;
    pixels.reserve(4 * static_cast<std::size_t>(part.width) *
                   static_cast<std::size_t>(part.height));
    for (int y = top; y < bottom; ++y) {
        const auto row =
            rgba.subspan(4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(width_px) +
                              static_cast<std::size_t>(left)),
                         4 * static_cast<std::size_t>(part.width));
        pixels.insert(pixels.end(), row.begin(), row.end());
    }
    return pixels;
}

}  // namespace gripscan::ui
