#include "core/scene/pixel_history.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <span>

namespace gripscan {
namespace {

/// Observations further apart than so many deviations are of different surfaces: noise alone opens
/// such a gap between neighbours among eight in less than one pixel of a million, also where its
/// texture makes it twice as noisy as usual.
constexpr double kGap_sigmas = 10.0;
constexpr std::size_t kFewest = 2;
constexpr double kLeastShare = 0.25;
constexpr double kUsualViews = 4.0;

double mean_of(std::span<const double> values) {
    return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

double squares_of(std::span<const double> values) {
    const double mean = mean_of(values);
    double sum = 0.0;
    for (const double value : values) sum += (value - mean) * (value - mean);
    return sum;
}

std::vector<std::span<const double>> surfaces_of(const std::vector<double>& values, double gap) {
    std::vector<std::span<const double>> surfaces;
    const auto fewest = std::max(
        kFewest,
        static_cast<std::size_t>(std::ceil(kLeastShare * static_cast<double>(values.size()))));
    std::size_t begin = 0;
    for (std::size_t i = 1; i <= values.size(); ++i) {
        if (i < values.size() && values[i] - values[i - 1] <= gap) continue;
        if (i - begin >= fewest) surfaces.emplace_back(values.data() + begin, i - begin);
        begin = i;
    }
    return surfaces;
}

}  // namespace

std::optional<PixelSurface> environment_of(const std::vector<double>& values,
                                           const HistorySettings& settings) {
    auto surfaces = surfaces_of(values, kGap_sigmas * settings.noise_per_m);
    if (surfaces.empty()) return std::nullopt;
    if (settings.farthest_only) surfaces.resize(1);
    const auto main =
        std::max_element(surfaces.begin(), surfaces.end(),
                         [](const auto& a, const auto& b) { return a.size() < b.size(); });
    PixelSurface surface;
    surface.mean = mean_of(*main);
    surface.far = mean_of(surfaces.front());
    surface.near = mean_of(surfaces.back());
    double squares = 0.0;
    for (const auto& part : surfaces) {
        squares += squares_of(part);
        surface.views += static_cast<int>(part.size());
    }
    // A handful of views tells a deviation badly: the usual one counts like some views more.
    const double freedom = surface.views - static_cast<double>(surfaces.size());
    const double usual = settings.noise_per_m * settings.noise_per_m;
    surface.sigma = std::max(settings.noise_per_m,
                             std::sqrt((squares + kUsualViews * usual) / (freedom + kUsualViews)));
    return surface;
}

double variance_for_median(const std::vector<double>& values) {
    const double freedom = static_cast<double>(values.size()) - 1.0;
    // Wilson and Hilferty 1931.
    const double median_over_mean = std::pow(1.0 - 2.0 / (9.0 * freedom), 3.0);
    return squares_of(values) / freedom / median_over_mean;
}

}  // namespace gripscan
