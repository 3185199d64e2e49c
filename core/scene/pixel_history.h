// What one pixel has seen over all captures, told apart into surfaces.
#pragma once

#include <optional>
#include <vector>

namespace gripscan {

/// The environment's part of a pixel's history; inverse depths, 1/m.
struct PixelSurface {
    double mean = 0.0;   ///< of the surface that was seen most
    double far = 0.0;    ///< mean of the farthest surface and
    double near = 0.0;   ///< of the nearest one
    double sigma = 0.0;  ///< of one observation
    int views = 0;
};

struct HistorySettings {
    double noise_per_m = 0.0;  ///< usual deviation of an inverse depth
    bool farthest_only = false;
};

/// `values` (sorted, rising: far ones first) fall into surfaces where they leave gaps. A surface
/// counts if it was seen twice and in a quarter of the captures that saw anything; with
/// `farthest_only` the farthest of them is the environment, else all are. Nothing if none counts.
[[nodiscard]] std::optional<PixelSurface> environment_of(const std::vector<double>& values,
                                                         const HistorySettings& settings);

/// Variance of the values, made comparable for any number of them by the ratio of the chi-squared
/// distribution's median to its mean; needs two.
[[nodiscard]] double variance_for_median(const std::vector<double>& values);

}  // namespace gripscan
