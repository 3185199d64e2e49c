// Weighted windows around pixels, eight neighbouring pixels at a time so that the compiler can
// use vector instructions; each pixel's sums are its own, so results do not depend on threads.
#pragma once

#include <array>
#include <cmath>
#include <opencv2/core.hpp>
#include <vector>

#include "core/base/for_each.h"

namespace gripscan {

inline constexpr int kLanes = 8;
using Lanes = std::array<float, kLanes>;

/// One neighbour of a window.
struct WindowTap {
    int dx, dy;
    float weight;  ///< 1 in the centre, falling to 0 just outside the radius
};

/// The disc of the radius.
[[nodiscard]] inline std::vector<WindowTap> window_taps(int radius) {
    std::vector<WindowTap> taps;
    const float rim2 = static_cast<float>((radius + 1) * (radius + 1));
    for (int dy = -radius; dy <= radius; ++dy) {
        for (int dx = -radius; dx <= radius; ++dx) {
            const float fall = 1.0F - static_cast<float>(dx * dx + dy * dy) / rim2;
            if (fall > 0.0F) taps.push_back({dx, dy, fall * fall});
        }
    }
    return taps;
}

/// Tukey's weight of a residual in units of its limit, given squared.
[[nodiscard]] inline float tukey(float squared) {
    const float keep = squared < 1.0F ? 1.0F - squared : 0.0F;
    return keep * keep;
}

/// A map with `pad` columns and rows around it (and a few more columns, so that a group of lanes
/// may start at any pixel).
[[nodiscard]] inline cv::Mat padded_map(const cv::Mat& map, int pad, float outside) {
    cv::Mat padded;
    cv::copyMakeBorder(map, padded, pad, pad, pad, pad + kLanes, cv::BORDER_CONSTANT,
                       cv::Scalar::all(static_cast<double>(outside)));
    return padded;
}

/// Calls body(y, x) for every group of lanes [x, x + kLanes) that holds a pixel with known[·] > 0;
/// `known` is padded by `pad`. Rows run side by side.
template <typename Body>
void for_each_group(const cv::Mat& known, int pad, cv::Size size, const ForEach& for_each,
                    const Body& body) {
    for_each(static_cast<std::size_t>(size.height), [&](std::size_t row) {
        const int y = static_cast<int>(row);
        const auto* k = known.ptr<float>(y + pad) + pad;
        for (int x = 0; x < size.width; x += kLanes) {
            bool any = false;
            for (int i = 0; i < kLanes; ++i) any = any || k[x + i] > 0.0F;
            if (any) body(y, x);
        }
    });
}

}  // namespace gripscan
