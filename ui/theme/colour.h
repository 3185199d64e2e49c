// A colour of the screen (sRGB) and how well two of them can be told apart.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

namespace gripscan::ui {

struct Colour {
    std::uint8_t r = 0;
    std::uint8_t g = 0;
    std::uint8_t b = 0;
    std::uint8_t a = 255;

    /// The same colour, so opaque (0 … 1).
    [[nodiscard]] constexpr Colour with_alpha(double alpha) const {
        return {r, g, b, static_cast<std::uint8_t>(alpha * 255.0 + 0.5)};
    }
    /// As Dear ImGui packs it.
    [[nodiscard]] constexpr std::uint32_t packed() const {
        return static_cast<std::uint32_t>(r) | static_cast<std::uint32_t>(g) << 8U |
               static_cast<std::uint32_t>(b) << 16U | static_cast<std::uint32_t>(a) << 24U;
    }
    friend constexpr bool operator==(const Colour&, const Colour&) = default;
};

/// From "#RRGGBB" or "#RRGGBBAA".
[[nodiscard]] std::optional<Colour> colour_from_text(std::string_view text);

/// From `a` (t = 0) to `b` (t = 1), channel by channel.
[[nodiscard]] Colour mixed(const Colour& a, const Colour& b, double t);

/// What `top` looks like over `below`.
[[nodiscard]] Colour over(const Colour& top, const Colour& below);

/// Contrast ratio of WCAG 2.1, 1 … 21; alpha is ignored. Text wants 4.5 (AA), marks want 3.
[[nodiscard]] double contrast(const Colour& one, const Colour& other);

}  // namespace gripscan::ui
