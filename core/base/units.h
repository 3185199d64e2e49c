// Metres and radians inside; degrees and millimetres only at the border, by these names.
#pragma once

#include <numbers>

namespace gripscan {

inline constexpr double kRadPerDeg = std::numbers::pi / 180.0;
inline constexpr double kDegPerRad = 180.0 / std::numbers::pi;
inline constexpr double kMmPerM = 1000.0;

[[nodiscard]] constexpr double rad_from_deg(double deg) { return deg * kRadPerDeg; }
[[nodiscard]] constexpr double deg_from_rad(double rad) { return rad * kDegPerRad; }

}  // namespace gripscan
