#include "ui/theme/on_plate.h"

#include <algorithm>
#include <cmath>

namespace gripscan::ui {
namespace {

constexpr double kReadable = 4.5;
constexpr Colour kWhite{255, 255, 255};

std::uint8_t level(double value) {
    return static_cast<std::uint8_t>(std::lround(std::clamp(value, 0.0, 255.0)));
}

/// All channels times `factor`: the same hue.
Colour brighter(const Colour& c, double factor) {
    return {level(c.r * factor), level(c.g * factor), level(c.b * factor), c.a};
}

}  // namespace

Colour on_plate(const Theme& theme, const Colour& colour) {
    const Colour surface = over(theme.plate, kWhite);
    const auto readable = [&](const Colour& c) { return contrast(c, surface) >= kReadable; };
    if (readable(colour)) return colour;
    // As bright as the hue can be, then paler.
    const double most = 255.0 / std::max({1, int{colour.r}, int{colour.g}, int{colour.b}});
    constexpr int kSteps = 20;
    for (int i = 1; i <= kSteps; ++i) {
        const Colour c = brighter(colour, 1.0 + (most - 1.0) * i / kSteps);
        if (readable(c)) return c;
    }
    for (int i = 1; i < kSteps; ++i) {
        const Colour c = mixed(brighter(colour, most), kWhite.with_alpha(colour.a / 255.0),
                               static_cast<double>(i) / kSteps);
        if (readable(c)) return c;
    }
    return kWhite;
}

}  // namespace gripscan::ui
