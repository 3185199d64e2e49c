// A single view made ready to be searched.
#pragma once

#include <optional>

#include "core/base/for_each.h"
#include "core/base/result.h"
#include "core/cloud/cloud.h"
#include "core/cloud/kd_tree.h"
#include "core/recognition/oriented_points.h"
#include "core/recognition/view_map.h"

namespace gripscan {

/// The view at the coarseness of one template.
struct CoarseScene {
    OrientedPoints points;
    KdTree tree{std::span<const Eigen::Vector3f>{}};
};

struct SceneView {
    OrientedPoints points;    ///< all of them, as measured
    double noise_m = 0.0;     ///< standard deviation along the line of sight, the median
    bool noise_told = false;  ///< by the camera; else it is what neighbours differ by, and less
    ViewMap map;
    OrientedPoints thin;  ///< some millimetres apart: what coarse scenes are made from
    double thin_m = 0.0;

    [[nodiscard]] CoarseScene coarse(double step_m) const;
};

/// Normals and noise are computed where the cloud does not bring them. Without a viewpoint the
/// camera is taken to stand in the origin. Error: fewer than 100 points.
[[nodiscard]] Result<SceneView> make_scene_view(const Cloud& cloud, double finest_step_m,
                                                const ForEach& for_each);

}  // namespace gripscan
