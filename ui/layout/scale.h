// Lengths of the design in em (1 em = the text size, 14 px at 100 %) as whole pixels.
#pragma once

#include <algorithm>
#include <cmath>

namespace gripscan::ui {

inline constexpr float kTextSizePx = 14.0F;

class Scale {
  public:
    /// Content scale of the monitor times the user's factor; kept in [0.5, 4], 1 if it is no
    /// number.
    explicit Scale(float factor = 1.0F)
        : factor_(std::isfinite(factor) ? std::clamp(factor, 0.5F, 4.0F) : 1.0F) {}

    [[nodiscard]] float factor() const { return factor_; }
    /// Whole pixels of a length in em.
    [[nodiscard]] float em(float length_em) const {
        return std::round(length_em * kTextSizePx * factor_);
    }
    /// Whole pixels of a length that is given in px at 100 %.
    [[nodiscard]] float px(float length_px) const { return std::round(length_px * factor_); }
    /// Separators and borders: 1 px up to 149 %, 2 px up to 249 %, 3 px above.
    [[nodiscard]] float line() const {
        return factor_ < 1.5F ? 1.0F : factor_ < 2.5F ? 2.0F : 3.0F;
    }
    friend bool operator==(const Scale&, const Scale&) = default;

  private:
    float factor_;
};

}  // namespace gripscan::ui
