#include "ui/render/point_chunk.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "core/base/seeded_random.h"

namespace gripscan::ui {
namespace {

std::int8_t packed_normal(float n) {
    return static_cast<std::int8_t>(std::lround(std::clamp(n, -1.0F, 1.0F) * 127.0F));
}

std::vector<std::uint32_t> shuffled(std::size_t size, std::uint64_t seed) {
    std::vector<std::uint32_t> order(size);
    std::iota(order.begin(), order.end(), 0U);
    SeededRandom random(seed);
    for (std::size_t i = size; i > 1; --i) std::swap(order[i - 1], order[random.next() % i]);
    return order;
}

}  // namespace

std::vector<PackedPoint> packed_points(const PointChunk& chunk) {
    if (!chunk.cloud) return {};
    const Cloud& cloud = *chunk.cloud;
    const bool residuals = chunk.residual_m && chunk.residual_m->size() == cloud.size();
    std::vector<PackedPoint> packed;
    packed.reserve(cloud.size());
    for (const std::uint32_t i : shuffled(cloud.size(), chunk.id)) {
        PackedPoint p{};
        p.x_m = cloud.points[i].x();
        p.y_m = cloud.points[i].y();
        p.z_m = cloud.points[i].z();
        if (cloud.has_normals()) {
            p.nx = packed_normal(cloud.normals[i].x());
            p.ny = packed_normal(cloud.normals[i].y());
            p.nz = packed_normal(cloud.normals[i].z());
        }
        p.intensity = cloud.intensity.empty()
                          ? std::uint8_t{160}
                          : static_cast<std::uint8_t>(std::clamp(cloud.intensity[i], 0.0F, 255.0F));
        p.seen = cloud.seen.empty() ? std::uint16_t{1} : cloud.seen[i];
        p.step = chunk.step;
        p.residual_m = residuals ? (*chunk.residual_m)[i] : -1.0F;  // unknown
        p.sigma_m = cloud.sigma.empty() ? 0.0F : cloud.sigma[i];
        packed.push_back(p);
    }
    return packed;
}

Box bounds_of(std::span<const Eigen::Vector3f> points_m) {
    constexpr float kFar = std::numeric_limits<float>::max();
    Eigen::Vector3f low = Eigen::Vector3f::Constant(kFar);
    Eigen::Vector3f high = Eigen::Vector3f::Constant(-kFar);
    for (const Eigen::Vector3f& p : points_m) {
        low = low.cwiseMin(p);
        high = high.cwiseMax(p);
    }
    return {low.cast<double>(), high.cast<double>()};
}

}  // namespace gripscan::ui
