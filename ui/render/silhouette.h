// The outline of a cloud as it is seen: where a thing will be before it is there.
#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "core/geometry/pose.h"
#include "ui/render/orbit_camera.h"

namespace gripscan::ui {

struct SilhouetteSettings {
    double cell_px = 6.0;  ///< of the mask that is traced; gaps below two cells are closed
    std::size_t most_points = 20000;  ///< an even sample is enough
    double least_px = 40.0;           ///< shorter outlines are specks
};

/// Closed outlines in px (the first point is repeated at the end), in a fixed order.
[[nodiscard]] std::vector<std::vector<Eigen::Vector2d>> silhouette(
    std::span<const Eigen::Vector3f> points_m, const Pose& T_world_cloud, const OrbitCamera& camera,
    const Viewport& viewport, const SilhouetteSettings& settings = {});

}  // namespace gripscan::ui
