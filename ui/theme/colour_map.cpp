#include "ui/theme/colour_map.h"

#include <algorithm>
#include <cmath>
#include <span>

namespace gripscan::ui {
namespace {

constexpr Colour kStep[] = {{70, 98, 170},  {52, 124, 170}, {46, 152, 160}, {62, 178, 134},
                            {124, 198, 98}, {190, 212, 84}, {246, 226, 96}};
constexpr Colour kSeen[] = {{92, 74, 148},  {70, 110, 180}, {52, 148, 170},
                            {72, 184, 138}, {160, 208, 92}, {246, 226, 96}};
constexpr Colour kResidual[] = {{34, 48, 60},    {47, 95, 134},  {91, 155, 196}, {201, 211, 218},
                                {240, 194, 122}, {229, 138, 78}, {214, 80, 60}};
constexpr Colour kDepth[] = {{24, 20, 60},   {78, 44, 120},   {140, 52, 122}, {202, 72, 98},
                             {240, 122, 84}, {252, 186, 120}, {252, 240, 190}};

std::span<const Colour> stops_of(ColourMap map) {
    switch (map) {
        case ColourMap::kSeen:
            return kSeen;
        case ColourMap::kResidual:
            return kResidual;
        case ColourMap::kDepth:
            return kDepth;
        case ColourMap::kStep:
            break;
    }
    return kStep;
}

}  // namespace

Colour map_colour(ColourMap map, double t) {
    const auto stops = stops_of(map);
    const double last = static_cast<double>(stops.size() - 1);
    const double at = t > 0.0 ? std::min(t, 1.0) * last : 0.0;
    const auto below = std::min(static_cast<std::size_t>(at), stops.size() - 2);
    return mixed(stops[below], stops[below + 1], at - static_cast<double>(below));
}

std::array<std::uint8_t, 1024> map_bytes(ColourMap map) {
    std::array<std::uint8_t, 1024> bytes{};
    for (std::size_t i = 0; i < 256; ++i) {
        const Colour c = map_colour(map, static_cast<double>(i) / 255.0);
        bytes[4 * i] = c.r;
        bytes[4 * i + 1] = c.g;
        bytes[4 * i + 2] = c.b;
        bytes[4 * i + 3] = 255;
    }
    return bytes;
}

}  // namespace gripscan::ui
