// Many views into one template: every point with the number of views that saw it and its standard
// deviation, and nothing that other views have looked through.
#pragma once

#include <span>

#include "core/base/for_each.h"
#include "core/cloud/cloud.h"
#include "core/geometry/pose.h"
#include "core/registration/surface.h"

namespace gripscan {

struct MergeSettings {
    double voxel_m = 1.0e-3;
    int min_seen = 2;  ///< views that must have seen a point
};

struct PosedView {
    const Cloud* cloud = nullptr;  ///< camera frame, with normals
    Pose T_first_view = Pose::Identity();
    const Surface* holder = nullptr;  ///< what held the part, camera frame: it hides; null: nothing
};

/// One point a voxel (two where front and back of a thin wall share one): the noise-weighted mean
/// of the surface around it along its normal. `sigma` of the result is the standard deviation of
/// that mean, `seen` the number of views. Points that more views looked through than saw are
/// dropped, so debris at silhouettes does not enter.
[[nodiscard]] Cloud merge_views(std::span<const PosedView> views, const MergeSettings& settings,
                                const ForEach& for_each);

}  // namespace gripscan
