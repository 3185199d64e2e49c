#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "core/cloud/filters.h"

namespace gripscan {
namespace {

using Voxel = std::array<std::int64_t, 3>;

Voxel voxel_of(const Eigen::Vector3f& p, double voxel_m) {
    // Beyond this the cast would overflow; points this far apart never share a voxel in practice.
    constexpr double kFar = 4e18;
    Voxel voxel{};
    for (int axis = 0; axis < 3; ++axis) {
        const double index = std::floor(static_cast<double>(p[axis]) / voxel_m);
        voxel[static_cast<std::size_t>(axis)] =
            static_cast<std::int64_t>(std::clamp(index, -kFar, kFar));
    }
    return voxel;
}

/// Points that share a voxel, in rising order; groups in the order of their first point.
std::vector<std::vector<std::size_t>> groups_of(const Cloud& cloud, double voxel_m) {
    std::vector<Voxel> voxels;
    voxels.reserve(cloud.size());
    for (const auto& p : cloud.points) voxels.push_back(voxel_of(p, voxel_m));
    std::vector<std::size_t> order(cloud.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return voxels[a] < voxels[b]; });
    std::vector<std::vector<std::size_t>> groups;
    for (const std::size_t i : order) {
        if (groups.empty() || voxels[groups.back().front()] != voxels[i]) groups.emplace_back();
        groups.back().push_back(i);
    }
    std::sort(groups.begin(), groups.end(),
              [](const auto& a, const auto& b) { return a.front() < b.front(); });
    return groups;
}

Eigen::Vector3d mean_of(const std::vector<Eigen::Vector3f>& all,
                        const std::vector<std::size_t>& group) {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (const std::size_t i : group) sum += all[i].cast<double>();
    return sum / static_cast<double>(group.size());
}

float mean_of(const std::vector<float>& all, const std::vector<std::size_t>& group) {
    double sum = 0.0;
    for (const std::size_t i : group) sum += static_cast<double>(all[i]);
    return static_cast<float>(sum / static_cast<double>(group.size()));
}

/// Both sides of a thin sheet in one voxel cancel out: then the first normal stands for all.
Eigen::Vector3f mean_normal(const Cloud& cloud, const std::vector<std::size_t>& group) {
    const Eigen::Vector3d mean = mean_of(cloud.normals, group);
    if (mean.norm() < 0.1) return cloud.normals[group.front()];
    return mean.normalized().cast<float>();
}

std::uint16_t most_seen(const Cloud& cloud, const std::vector<std::size_t>& group) {
    std::uint16_t most = 0;
    for (const std::size_t i : group) most = std::max(most, cloud.seen[i]);
    return most;
}

}  // namespace

Cloud thinned(const Cloud& cloud, double voxel_m) {
    Cloud result;
    result.viewpoint = cloud.viewpoint;
    for (const auto& group : groups_of(cloud, voxel_m)) {
        result.points.push_back(mean_of(cloud.points, group).cast<float>());
        if (cloud.has_normals()) result.normals.push_back(mean_normal(cloud, group));
        if (!cloud.intensity.empty()) result.intensity.push_back(mean_of(cloud.intensity, group));
        if (!cloud.sigma.empty()) result.sigma.push_back(mean_of(cloud.sigma, group));
        if (!cloud.seen.empty()) result.seen.push_back(most_seen(cloud, group));
    }
    return result;
}

}  // namespace gripscan
