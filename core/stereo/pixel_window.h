// Weighted windows around pixels, eight neighbouring pixels at a time so that the compiler can
// use vector instructions; each pixel's sums are its own, so results do not depend on threads.
#pragma once

#include <cmath>
#include <cstring>
#include <opencv2/core.hpp>
#include <vector>

#include "core/base/for_each.h"

namespace gripscan {

inline constexpr int kLanes = 8;
/// Eight floats as one value (a vector type of gcc and clang; every processor can do it).
using Lanes [[gnu::vector_size(kLanes * sizeof(float))]] = float;

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

/// For the innermost loops: compiled twice, for processors with and without 256-bit vectors; the
/// results are the same to the last bit. Sanitizers cannot start programs that choose at load time.
#if defined(__x86_64__) && !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
#define GRIPSCAN_FAST [[gnu::target_clones("avx2", "default")]]
#else
#define GRIPSCAN_FAST
#endif

[[nodiscard, gnu::always_inline]] inline Lanes load(const float* from) {
    Lanes lanes;
    std::memcpy(&lanes, from, sizeof lanes);
    return lanes;
}

/// Tukey's weight of a residual in units of its limit, given squared.
[[nodiscard, gnu::always_inline]] inline Lanes tukey(const Lanes& squared) {
    const Lanes keep = squared < 1.0F ? 1.0F - squared : Lanes{};
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
