#include "ui/theme/colour.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace gripscan::ui {
namespace {

std::optional<unsigned> hex_digit(char c) {
    if (c >= '0' && c <= '9') return static_cast<unsigned>(c - '0');
    if (c >= 'a' && c <= 'f') return static_cast<unsigned>(c - 'a' + 10);
    if (c >= 'A' && c <= 'F') return static_cast<unsigned>(c - 'A' + 10);
    return std::nullopt;
}

std::uint8_t rounded(double value) {
    return static_cast<std::uint8_t>(std::clamp(value + 0.5, 0.0, 255.0));
}

/// Light of one channel, 0 … 1 (WCAG 2.1, relative luminance).
double linear(std::uint8_t channel) {
    const double c = channel / 255.0;
    return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
}

double luminance(const Colour& c) {
    return 0.2126 * linear(c.r) + 0.7152 * linear(c.g) + 0.0722 * linear(c.b);
}

}  // namespace

std::optional<Colour> colour_from_text(std::string_view text) {
    if ((text.size() != 7 && text.size() != 9) || text[0] != '#') return std::nullopt;
    std::array<std::uint8_t, 4> channels{0, 0, 0, 255};
    for (std::size_t i = 0; 2 * i + 1 < text.size(); ++i) {
        const auto high = hex_digit(text[2 * i + 1]);
        const auto low = hex_digit(text[2 * i + 2]);
        if (!high || !low) return std::nullopt;
        channels[i] = static_cast<std::uint8_t>(*high * 16U + *low);
    }
    return Colour{channels[0], channels[1], channels[2], channels[3]};
}

Colour mixed(const Colour& a, const Colour& b, double t) {
    const auto mix = [t](std::uint8_t from, std::uint8_t to) {
        return rounded(from + t * (static_cast<double>(to) - from));
    };
    return {mix(a.r, b.r), mix(a.g, b.g), mix(a.b, b.b), mix(a.a, b.a)};
}

Colour over(const Colour& top, const Colour& below) {
    Colour opaque = top;
    opaque.a = 255;
    return mixed(below, opaque, top.a / 255.0);
}

double contrast(const Colour& one, const Colour& other) {
    const double a = luminance(one);
    const double b = luminance(other);
    return (std::max(a, b) + 0.05) / (std::min(a, b) + 0.05);
}

}  // namespace gripscan::ui
