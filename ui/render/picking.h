// Which point lies under the cursor.
#pragma once

#include <optional>
#include <span>

#include "ui/render/orbit_camera.h"
#include "ui/render/point_chunk.h"

namespace gripscan::ui {

struct PickedPoint {
    std::size_t chunk = 0;                                 ///< index in the span
    std::size_t point = 0;                                 ///< index in its cloud
    Eigen::Vector3d position_m = Eigen::Vector3d::Zero();  ///< in the world
    double distance_px = 0.0;                              ///< from the cursor
};

struct PickSettings {
    double radius_px = 8.0;
    double surface_m = 0.002;  ///< points this much behind the frontmost are of the same surface
    std::size_t stride = 1;    ///< looks at every stride-th point only: for reading while moving
};

/// The nearest to the cursor, in px, of the frontmost surface within the radius.
[[nodiscard]] std::optional<PickedPoint> pick_point(std::span<const PointChunk> chunks,
                                                    const OrbitCamera& camera,
                                                    const Viewport& viewport,
                                                    const Eigen::Vector2d& cursor_px,
                                                    const PickSettings& settings = {});

}  // namespace gripscan::ui
