#include "core/registration/visibility.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace gripscan {
namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();
/// Cosine between normals that may belong to the same spot.
constexpr float kSameNormal = 0.7F;

struct Shares {
    double matched = 0.0;
    double contradicted = 0.0;
};

Shares one_way(const Surface& from, const Surface& to, const DepthMap* map,
               std::span<const std::uint32_t> sample, const Pose& T_to_from, float tolerance_m) {
    const Eigen::Matrix3f R = T_to_from.linear().cast<float>();
    const Eigen::Vector3f t = T_to_from.translation().cast<float>();
    std::size_t matched = 0;
    std::size_t contradicted = 0;
    for (const std::uint32_t i : sample) {
        const Eigen::Vector3f p = R * from.points[i] + t;
        const auto found = to.tree.nearest_within(p, tolerance_m);
        if (found && (R * from.normals[i]).dot(to.normals[found->index]) > kSameNormal) {
            ++matched;
        } else if (map != nullptr && map->look(p, 2.0F * tolerance_m) == Sight::kInFront) {
            ++contradicted;
        }
    }
    const double n = static_cast<double>(std::max<std::size_t>(1, sample.size()));
    return {static_cast<double>(matched) / n, static_cast<double>(contradicted) / n};
}

}  // namespace

DepthMap::DepthMap(const Surface& surface) : viewpoint_(*surface.viewpoint) {
    const Eigen::Vector3f forward = (surface.centre_m.cast<float>() - viewpoint_).normalized();
    R_map_camera_ =
        Eigen::Quaternionf::FromTwoVectors(forward, Eigen::Vector3f::UnitZ()).toRotationMatrix();
    float u1 = -kInfinity, v1 = -kInfinity;
    u0_ = v0_ = kInfinity;
    const auto visit = [&](const auto& use) {
        for (const auto& p : surface.points) {
            const Eigen::Vector3f local = R_map_camera_ * (p - viewpoint_);
            if (local.z() > 0.0F) use(local);
        }
    };
    visit([&](const Eigen::Vector3f& l) {
        u0_ = std::min(u0_, l.x() / l.z());
        v0_ = std::min(v0_, l.y() / l.z());
        u1 = std::max(u1, l.x() / l.z());
        v1 = std::max(v1, l.y() / l.z());
    });
    const float distance = (surface.centre_m.cast<float>() - viewpoint_).norm();
    // Cells of three point spacings: fine enough for the shape, coarse enough to have no holes.
    cells_per_unit_ = distance / static_cast<float>(3.0 * std::max(surface.spacing_m, 1e-6));
    width_ = std::clamp(static_cast<int>((u1 - u0_) * cells_per_unit_) + 1, 1, 4096);
    height_ = std::clamp(static_cast<int>((v1 - v0_) * cells_per_unit_) + 1, 1, 4096);
    const auto cells = static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_);
    nearest_.assign(cells, kInfinity);
    farthest_.assign(cells, -kInfinity);
    visit([&](const Eigen::Vector3f& l) {
        int column = 0;
        int row = 0;
        if (!cell_of(l, column, row)) return;
        const auto i = static_cast<std::size_t>(row * width_ + column);
        nearest_[i] = std::min(nearest_[i], l.z());
        farthest_[i] = std::max(farthest_[i], l.z());
    });
}

bool DepthMap::cell_of(const Eigen::Vector3f& local, int& column, int& row) const {
    column = static_cast<int>(std::floor((local.x() / local.z() - u0_) * cells_per_unit_));
    row = static_cast<int>(std::floor((local.y() / local.z() - v0_) * cells_per_unit_));
    return column >= 0 && column < width_ && row >= 0 && row < height_;
}

Sight DepthMap::look(const Eigen::Vector3f& p, float tolerance_m) const {
    const Eigen::Vector3f local = R_map_camera_ * (p - viewpoint_);
    int column = 0;
    int row = 0;
    if (local.z() <= 0.0F || !cell_of(local, column, row)) return Sight::kNothing;
    const auto i = static_cast<std::size_t>(row * width_ + column);
    if (nearest_[i] == kInfinity) return Sight::kNothing;
    if (local.z() < nearest_[i] - tolerance_m) return Sight::kInFront;
    return local.z() > farthest_[i] + tolerance_m ? Sight::kHidden : Sight::kSeen;
}

Agreement agreement(const Surface& source, const Surface& target, const DepthMap* source_map,
                    const DepthMap* target_map, std::span<const std::uint32_t> source_sample,
                    std::span<const std::uint32_t> target_sample, const Pose& T_target_source,
                    double tolerance_m) {
    const auto tolerance = static_cast<float>(tolerance_m);
    const Shares there =
        one_way(source, target, target_map, source_sample, T_target_source, tolerance);
    const Shares back =
        one_way(target, source, source_map, target_sample, T_target_source.inverse(), tolerance);
    Agreement result;
    result.matched = 0.5 * (there.matched + back.matched);
    result.contradicted = 0.5 * (there.contradicted + back.contradicted);
    result.score = result.matched - result.contradicted;
    return result;
}

Agreement agreement_at(const Surface& source, const Surface& target, const Pose& T_target_source,
                       std::size_t points) {
    std::optional<DepthMap> source_map;
    std::optional<DepthMap> target_map;
    if (source.viewpoint) source_map.emplace(source);
    if (target.viewpoint) target_map.emplace(target);
    const auto source_sample = spread_sample(source, points);
    const auto target_sample = spread_sample(target, points);
    return agreement(source, target, source_map ? &*source_map : nullptr,
                     target_map ? &*target_map : nullptr, source_sample, target_sample,
                     T_target_source, rough_tolerance_m(source, target));
}

double rough_tolerance_m(const Surface& source, const Surface& target) {
    return std::max(0.02 * std::max(source.radius_m, target.radius_m),
                    2.0 * std::max(source.spacing_m, target.spacing_m));
}

}  // namespace gripscan
