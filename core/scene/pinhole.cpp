#include "core/scene/pinhole.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "core/base/median.h"

namespace gripscan {
namespace {

/// Sums of a straight line u = f · s + c by least squares.
struct LineFit {
    double n = 0.0, s = 0.0, u = 0.0, ss = 0.0, su = 0.0, uu = 0.0;

    void add(double slope, double pixel) {
        n += 1.0;
        s += slope;
        u += pixel;
        ss += slope * slope;
        su += slope * pixel;
        uu += pixel * pixel;
    }
    [[nodiscard]] double spread() const { return n * ss - s * s; }
    [[nodiscard]] double f() const { return (n * su - s * u) / spread(); }
    [[nodiscard]] double c() const { return (u - f() * s) / n; }
    [[nodiscard]] double rms() const {
        const double variance = (uu - f() * su - c() * u) / n;
        return std::sqrt(std::max(0.0, variance));
    }
};

struct Place {
    Eigen::Vector3d p;
    double u;
    double v;
};

Place place(const Cloud& cloud, std::size_t i) {
    return {cloud.points[i].cast<double>(), static_cast<double>(cloud.cell[i] % cloud.grid_width),
            static_cast<double>(cloud.cell[i] / cloud.grid_width)};
}

}  // namespace

std::optional<Pinhole> pinhole_of(const Cloud& cloud) {
    if (!cloud.organised() || cloud.size() < 100) return std::nullopt;
    LineFit columns;
    LineFit rows;
    for (std::size_t i = 0; i < cloud.size(); ++i) {
        const auto [p, u, v] = place(cloud, i);
        if (p.z() <= 0.0) return std::nullopt;
        columns.add(p.x() / p.z(), u);
        rows.add(p.y() / p.z(), v);
    }
    if (!(columns.spread() > 1e-9) || !(rows.spread() > 1e-9)) return std::nullopt;
    constexpr double kSameCamera_px = 0.1;
    if (columns.rms() > kSameCamera_px || rows.rms() > kSameCamera_px) return std::nullopt;
    return Pinhole{columns.f(), columns.c(), rows.f(), rows.c()};
}

double misfit_px(const Cloud& cloud, const Pinhole& camera) {
    constexpr std::size_t kPlaces = 2000;
    const std::size_t stride = cloud.size() / kPlaces + 1;
    std::vector<double> in_columns;
    std::vector<double> in_rows;
    for (std::size_t i = 0; i < cloud.size(); i += stride) {
        const auto [p, u, v] = place(cloud, i);
        const Eigen::Vector2d seen = camera.project(p);
        in_columns.push_back(std::abs(seen.x() - u));
        in_rows.push_back(std::abs(seen.y() - v));
    }
    if (in_columns.empty()) return 0.0;
    return std::max(median_of(std::move(in_columns)), median_of(std::move(in_rows)));
}

}  // namespace gripscan
