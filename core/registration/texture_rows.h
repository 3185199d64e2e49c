// Texture as a witness of motion: the brightness of one view, carried over the surface into the
// other, against the brightness found there.
#pragma once

#include <vector>

#include "core/registration/residual_row.h"
#include "core/registration/surface.h"

namespace gripscan {

/// Smoothing steps from coarse to fine; each reaches about as many pixels as it smooths.
inline constexpr int kTextureScales = 3;

/// Rows that compare the texture of both views at the given pose, in both directions, at one
/// scale (0 is the finest). The image of one view is warped by the surface into the grid of the
/// other *before* both are smoothed and freed of light (local mean and deviation): a smoothing
/// window that covered different parts of a curved surface in the two views would shift the
/// pattern. Points on rims, seen at a grazing angle or hidden in the other view have no row.
/// Weights are Tukey's at the scale of the residuals themselves, since two views of one texture
/// differ by more than sensor noise. Empty without image grids.
[[nodiscard]] std::vector<ResidualRow> texture_rows(const Surface& source, const Surface& target,
                                                    const Pose& T_target_source, int scale,
                                                    double gate_m, const Eigen::Vector3d& centre);

}  // namespace gripscan
