// Inverse depth and brightness as images of one grid, and smaller copies of them.
#pragma once

#include <optional>
#include <vector>

#include "core/scene/environment_model.h"

namespace gripscan {

/// Inverse depth 0: nothing is known there.
struct DepthImage {
    int width = 0;
    int height = 0;
    Pinhole camera;
    std::vector<float> inverse_depth_per_m;
    std::vector<float> grey;

    [[nodiscard]] std::size_t at(int u, int v) const {
        return static_cast<std::size_t>(v) * static_cast<std::size_t>(width) +
               static_cast<std::size_t>(u);
    }
};

[[nodiscard]] DepthImage image_of(const EnvironmentModel& model);
/// Of an organised cloud with this camera's grid.
[[nodiscard]] DepthImage image_of(const Cloud& cloud, const Pinhole& camera);

/// Every `factor` × `factor` pixels made one: the mean where at least half are known and lie on one
/// surface (to 4 % of their inverse depth).
[[nodiscard]] DepthImage shrunk(const DepthImage& image, int factor, const ForEach& for_each);

/// Value and slopes by bilinear interpolation.
struct ImageSample {
    double inverse_depth = 0.0;
    double inverse_depth_u = 0.0;
    double inverse_depth_v = 0.0;
    double grey = 0.0;
    double grey_u = 0.0;
    double grey_v = 0.0;
};
/// Nothing where one of the four pixels around is unknown or on another surface.
[[nodiscard]] std::optional<ImageSample> sample(const DepthImage& image, double u, double v);

}  // namespace gripscan
