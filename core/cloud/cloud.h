// The point cloud of gripscan: only finite points, each with what is known about it, and the
// image grid it came from.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "core/geometry/box.h"
#include "core/geometry/pose.h"

namespace gripscan {

/// Structure of arrays. `points` leads; every other array is either empty (unknown) or as long.
/// Points are always finite.
struct Cloud {
    std::vector<Eigen::Vector3f> points;   ///< m
    std::vector<Eigen::Vector3f> normals;  ///< unit vectors towards the viewpoint
    std::vector<float> intensity;          ///< image brightness, 0 … 255
    std::vector<float> sigma;              ///< standard deviation along the viewing ray, m
    std::vector<std::uint16_t> seen;       ///< number of views that saw the point

    /// Organised clouds: cell of every point in the grid, row · grid_width + column, rising.
    std::vector<std::int32_t> cell;
    int grid_width = 0;  ///< 0: no grid
    int grid_height = 0;

    /// Where the camera stood, m. Nothing: unknown.
    std::optional<Eigen::Vector3f> viewpoint;

    [[nodiscard]] std::size_t size() const { return points.size(); }
    [[nodiscard]] bool empty() const { return points.empty(); }
    [[nodiscard]] bool organised() const { return grid_width > 0 && !cell.empty(); }
    [[nodiscard]] bool has_normals() const { return !normals.empty(); }
};

/// The points named by `indices` (in that order), with all that is known about them.
[[nodiscard]] Cloud select(const Cloud& cloud, const std::vector<std::size_t>& indices);
/// The points inside the box.
[[nodiscard]] Cloud crop(const Cloud& cloud, const Box& box);
/// Points, normals and viewpoint moved by T.
[[nodiscard]] Cloud transformed(const Cloud& cloud, const Pose& T_target_source);
/// Mean of the points, m; zero for an empty cloud.
[[nodiscard]] Eigen::Vector3d centroid(const Cloud& cloud);
/// For organised clouds: index of the point in every cell of the grid, −1 where there is none.
[[nodiscard]] std::vector<std::int32_t> point_of_cell(const Cloud& cloud);

}  // namespace gripscan
