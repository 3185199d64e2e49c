#include "core/registration/region_walls.h"

namespace gripscan {
namespace {

/// Fewer points near a wall are strays.
constexpr int kTouching = 10;

}  // namespace

RegionWalls::RegionWalls(const Box& region, std::span<const Eigen::Vector3f> points, float margin_m)
    : min_m_(region.min_m.cast<float>()), max_m_(region.max_m.cast<float>()), margin_m_(margin_m) {
    std::array<int, 6> near{};
    for (const Eigen::Vector3f& p : points) {
        const auto distances = inside_m(p);
        for (int wall = 0; wall < 6; ++wall) {
            if (distances(wall) < margin_m_) ++near[static_cast<std::size_t>(wall)];
        }
    }
    for (std::size_t wall = 0; wall < near.size(); ++wall) cuts_[wall] = near[wall] >= kTouching;
}

Eigen::Array<float, 6, 1> RegionWalls::inside_m(const Eigen::Vector3f& p) const {
    Eigen::Array<float, 6, 1> distances;
    distances << p.array() - min_m_, max_m_ - p.array();
    return distances;
}

bool RegionWalls::leaves(const Eigen::Vector3f& p) const {
    const auto distances = inside_m(p);
    bool outside = false;
    for (int wall = 0; wall < 6; ++wall) {
        if (distances(wall) > -margin_m_) continue;
        if (cuts_[static_cast<std::size_t>(wall)]) return false;
        outside = true;
    }
    return outside;
}

bool RegionWalls::deep_inside(const Eigen::Vector3f& p) const {
    return (inside_m(p) > margin_m_).all();
}

}  // namespace gripscan
