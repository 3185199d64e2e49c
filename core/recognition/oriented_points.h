// Points that know which way their surface looks: what templates and scenes are matched by.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

namespace gripscan {

struct OrientedPoints {
    std::vector<Eigen::Vector3f> points;   ///< m
    std::vector<Eigen::Vector3f> normals;  ///< unit, out of the part

    [[nodiscard]] std::size_t size() const { return points.size(); }
    [[nodiscard]] bool empty() const { return points.empty(); }
    void add(const Eigen::Vector3f& point, const Eigen::Vector3f& normal) {
        points.push_back(point);
        normals.push_back(normal);
    }
};

/// The mean point for every cube of side voxel_m (> 0) and every way the surface in it looks: the
/// two faces of an edge, and front and back of a thin wall, stay apart. In order of first points.
[[nodiscard]] OrientedPoints thinned_by_normal(const OrientedPoints& all, double voxel_m);

/// The same with the smallest cubes that leave at most `count` points.
[[nodiscard]] OrientedPoints thinned_to(const OrientedPoints& all, double voxel_m,
                                        std::size_t count);

/// Diagonal of the points' bounding box, m.
[[nodiscard]] double diagonal_m(const OrientedPoints& points);

}  // namespace gripscan
