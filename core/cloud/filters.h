// What clouds need before they are compared: thinning, normals, and how noisy they are. All give
// the same answer in every run and for any number of threads.
#pragma once

#include "core/base/for_each.h"
#include "core/cloud/cloud.h"

namespace gripscan {

/// One point for every cube of side voxel_m (> 0) that holds points: their mean, with mean normal,
/// intensity and sigma and the largest seen-count. Cubes come in the order of their first point.
/// The result has no grid.
[[nodiscard]] Cloud thinned(const Cloud& cloud, double voxel_m);

struct NormalSettings {
    int neighbours = 16;   ///< clouds without a grid: nearest points of the plane
    int radius_cells = 3;  ///< clouds with a grid: half the side of the window
    /// With a grid: neighbours beyond this many typical point distances (times their distance in
    /// cells) lie on another surface.
    double jump_factor = 3.0;
};

/// Normals of local planes, in place of any the cloud has; empty if there are fewer than three
/// points. They point towards the viewpoint if it is known. Else, with a grid, all to the same side
/// of the grid's surface, and that is the side away from the centroid for most of them; without a
/// grid each points away from the centroid, which is right for compact parts only.
void estimate_normals(Cloud& cloud, const NormalSettings& settings, const ForEach& for_each);

/// Standard deviation of the points from local planes, m: the median over the cloud, so that edges
/// and flying pixels do not count. Curvature within a plane's few neighbours counts as noise, and
/// noise that neighbours share does not. Zero for fewer than `neighbours` points.
[[nodiscard]] double noise_estimate_m(const Cloud& cloud, const ForEach& for_each,
                                      int neighbours = 12);

}  // namespace gripscan
