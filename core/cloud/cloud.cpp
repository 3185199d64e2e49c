#include "core/cloud/cloud.h"

namespace gripscan {
namespace {

template <typename T>
std::vector<T> pick(const std::vector<T>& all, const std::vector<std::size_t>& indices) {
    std::vector<T> some;
    if (all.empty()) return some;
    some.reserve(indices.size());
    for (const std::size_t i : indices) some.push_back(all[i]);
    return some;
}

}  // namespace

Cloud select(const Cloud& cloud, const std::vector<std::size_t>& indices) {
    Cloud result;
    result.points = pick(cloud.points, indices);
    result.normals = pick(cloud.normals, indices);
    result.intensity = pick(cloud.intensity, indices);
    result.sigma = pick(cloud.sigma, indices);
    result.seen = pick(cloud.seen, indices);
    result.cell = pick(cloud.cell, indices);
    result.grid_width = cloud.grid_width;
    result.grid_height = cloud.grid_height;
    result.viewpoint = cloud.viewpoint;
    return result;
}

Cloud crop(const Cloud& cloud, const Box& box) {
    std::vector<std::size_t> inside;
    for (std::size_t i = 0; i < cloud.size(); ++i) {
        if (box.contains(cloud.points[i].cast<double>())) inside.push_back(i);
    }
    return select(cloud, inside);
}

Cloud transformed(const Cloud& cloud, const Pose& T_target_source) {
    Cloud result = cloud;
    const Eigen::Matrix3d R = T_target_source.linear();
    for (auto& p : result.points) p = (T_target_source * p.cast<double>()).cast<float>();
    for (auto& n : result.normals) n = (R * n.cast<double>()).cast<float>();
    if (result.viewpoint) {
        result.viewpoint = (T_target_source * result.viewpoint->cast<double>()).cast<float>();
    }
    return result;
}

Eigen::Vector3d centroid(const Cloud& cloud) {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (const auto& p : cloud.points) sum += p.cast<double>();
    return cloud.empty() ? sum : Eigen::Vector3d(sum / static_cast<double>(cloud.size()));
}

std::vector<std::int32_t> point_of_cell(const Cloud& cloud) {
    std::vector<std::int32_t> index(
        static_cast<std::size_t>(cloud.grid_width) * static_cast<std::size_t>(cloud.grid_height),
        -1);
    for (std::size_t i = 0; i < cloud.cell.size(); ++i) {
        index[static_cast<std::size_t>(cloud.cell[i])] = static_cast<std::int32_t>(i);
    }
    return index;
}

}  // namespace gripscan
