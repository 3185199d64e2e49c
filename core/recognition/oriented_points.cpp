#include "core/recognition/oriented_points.h"

#include <cmath>
#include <cstdint>
#include <unordered_map>

namespace gripscan {
namespace {

/// Normals closer than this (cosine) belong to one surface.
constexpr float kSameSurface = 0.85F;

struct Group {
    Eigen::Vector3f point_sum = Eigen::Vector3f::Zero();
    Eigen::Vector3f normal_sum = Eigen::Vector3f::Zero();
    float count = 0.0F;
    std::int32_t next = -1;  ///< further group of the same cube
};

std::int64_t cube_of(const Eigen::Vector3f& p, float scale) {
    // 21 bits a coordinate: a part or a scene is far smaller than a million cubes.
    const auto index = [&](float x) {
        return (static_cast<std::int64_t>(std::floor(x * scale)) + (1 << 20)) & ((1 << 21) - 1);
    };
    return index(p.x()) << 42 | index(p.y()) << 21 | index(p.z());
}

/// The group of that cube that looks the same way, made if there is none.
Group& group_for(std::vector<Group>& groups, std::int32_t& first, const Eigen::Vector3f& normal) {
    std::int32_t* link = &first;
    while (*link >= 0) {
        Group& group = groups[static_cast<std::size_t>(*link)];
        if (group.normal_sum.dot(normal) > kSameSurface * group.normal_sum.norm()) return group;
        link = &group.next;
    }
    *link = static_cast<std::int32_t>(groups.size());
    groups.emplace_back();
    return groups.back();
}

}  // namespace

OrientedPoints thinned_by_normal(const OrientedPoints& all, double voxel_m) {
    const auto scale = static_cast<float>(1.0 / voxel_m);
    std::vector<Group> groups;
    groups.reserve(all.size());  // links are kept as addresses while a cube is searched
    std::unordered_map<std::int64_t, std::int32_t> first_of;
    first_of.reserve(all.size() / 2);
    for (std::size_t i = 0; i < all.size(); ++i) {
        auto& first = first_of.try_emplace(cube_of(all.points[i], scale), -1).first->second;
        Group& group = group_for(groups, first, all.normals[i]);
        group.point_sum += all.points[i];
        group.normal_sum += all.normals[i];
        group.count += 1.0F;
    }
    OrientedPoints result;
    for (const Group& group : groups) {
        result.add(group.point_sum / group.count, group.normal_sum.normalized());
    }
    return result;
}

OrientedPoints thinned_to(const OrientedPoints& all, double voxel_m, std::size_t count) {
    OrientedPoints result = thinned_by_normal(all, voxel_m);
    while (result.size() > count) {
        voxel_m *=
            1.05 * std::sqrt(static_cast<double>(result.size()) / static_cast<double>(count));
        result = thinned_by_normal(all, voxel_m);
    }
    return result;
}

double diagonal_m(const OrientedPoints& points) {
    if (points.empty()) return 0.0;
    Eigen::Vector3f low = points.points.front();
    Eigen::Vector3f high = low;
    for (const auto& p : points.points) {
        low = low.cwiseMin(p);
        high = high.cwiseMax(p);
    }
    return static_cast<double>((high - low).norm());
}

}  // namespace gripscan
