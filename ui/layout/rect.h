// A rectangle on the screen, in whole pixels; x to the right, y downwards.
#pragma once

#include <algorithm>

namespace gripscan::ui {

struct Rect {
    int x = 0;
    int y = 0;
    int width = 0;
    int height = 0;

    [[nodiscard]] int right() const { return x + width; }
    [[nodiscard]] int bottom() const { return y + height; }
    [[nodiscard]] bool empty() const { return width <= 0 || height <= 0; }
    [[nodiscard]] bool contains(int px, int py) const {
        return px >= x && px < right() && py >= y && py < bottom();
    }
    [[nodiscard]] bool inside(const Rect& other) const {
        return x >= other.x && y >= other.y && right() <= other.right() &&
               bottom() <= other.bottom();
    }
    [[nodiscard]] bool overlaps(const Rect& other) const {
        return !empty() && !other.empty() && x < other.right() && other.x < right() &&
               y < other.bottom() && other.y < bottom();
    }
    /// What is left after `margin` on every side; never negative.
    [[nodiscard]] Rect shrunk(int margin) const {
        return {x + margin, y + margin, std::max(0, width - 2 * margin),
                std::max(0, height - 2 * margin)};
    }
    friend bool operator==(const Rect&, const Rect&) = default;
};

}  // namespace gripscan::ui
