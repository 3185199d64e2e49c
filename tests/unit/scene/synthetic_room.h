// A small room seen by a stereo camera with noise in its disparities: a wall, a slanted table, a
// post before the wall with a thin gap beside it.
#pragma once

#include <cmath>
#include <functional>

#include "core/base/seeded_random.h"
#include "core/cloud/cloud.h"

namespace gripscan::test {

struct SyntheticRoom {
    int width = 240;
    int height = 180;
    double f_px = 250.0;
    double baseline_m = 0.12;
    double noise_px = 0.05;
    /// A depth before the room at a pixel, 0: nothing there.
    std::function<double(int u, int v)> thing;
    double shift_m = 0.0;  ///< of the whole room along the camera's z

    [[nodiscard]] double fb() const { return f_px * baseline_m; }
    [[nodiscard]] double noise_per_m() const { return noise_px / fb(); }

    [[nodiscard]] double room_depth_m(int u, int v) const {
        double z = 1.8;
        if (v > 120) z = 1.8 - 0.012 * (v - 120);       // the table rises towards the camera
        if (u >= 100 && u < 118 && v <= 120) z = 1.30;  // a post …
        if (u >= 121 && u < 136 && v <= 120) z = 1.25;  // … and another, three pixels apart
        return z + shift_m;
    }

    /// A capture; at an edge a pixel sees either side or something between them, anew every time.
    [[nodiscard]] Cloud capture(std::uint64_t seed) const {
        SeededRandom random(seed);
        Cloud cloud;
        cloud.grid_width = width;
        cloud.grid_height = height;
        cloud.viewpoint = Eigen::Vector3f::Zero();
        for (int v = 0; v < height; ++v) {
            for (int u = 0; u < width; ++u) {
                double z = room_depth_m(u, v);
                const double beside = room_depth_m(std::min(u + 1, width - 1), v);
                const double flips = random.uniform();
                if (std::abs(beside - z) > 0.1) {
                    const double w = 1.0 / z + flips * (1.0 / beside - 1.0 / z);
                    z = flips < 0.3 ? z : flips > 0.7 ? beside : 1.0 / w;
                }
                const double before = thing ? thing(u, v) : 0.0;
                if (before > 0.0) z = before;
                const double w = 1.0 / z + noise_per_m() * random.normal();
                if (random.uniform() < 0.04) continue;  // not every pixel is matched every time
                z = 1.0 / w;
                const Eigen::Vector3d p((u - 0.5 * width) * z / f_px, (v - 0.5 * height) * z / f_px,
                                        z);
                cloud.points.push_back(p.cast<float>());
                cloud.sigma.push_back(static_cast<float>(p.norm() * z * noise_per_m()));
                cloud.intensity.push_back(
                    static_cast<float>(120.0 + 40.0 * std::sin(0.35 * u) * std::cos(0.27 * v)));
                cloud.cell.push_back(v * width + u);
            }
        }
        return cloud;
    }
};

}  // namespace gripscan::test
