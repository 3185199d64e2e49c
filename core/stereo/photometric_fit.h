// One Gauss–Newton step of the sub-pixel refinement (see refine.h for the equation), for every
// pixel with its own patch.
#pragma once

#include <functional>
#include <opencv2/core/mat.hpp>
#include <vector>

#include "core/base/for_each.h"
#include "core/stereo/local_plane.h"
#include "core/stereo/photometry.h"

namespace gripscan {

struct PatchSettings {
    float surface_tolerance_px;   ///< neighbours further from the plane are of another surface
    float residual_limit_levels;  ///< neighbours that differ more in brightness do not count
};

/// Result of a pixel.
struct PatchFit {
    float step_px = 0.0F;           ///< to be added to the current disparity
    float gain = 0.0F;              ///< right brightness over left, minus 1
    float sigma_px = 0.0F;          ///< standard deviation predicted from texture and residual
    float texture_to_noise = 0.0F;  ///< energy of the gradients against what noise makes of it
    float inliers = 0.0F;           ///< share of the patch's weight whose brightness fits
    float rms = 0.0F;               ///< brightness residual that no step explains, levels
    float contrast = 0.0F;          ///< standard deviation of the left patch, levels
    float lever_px = 0.0F;          ///< from the pixel to the centre of the texture that decided
};

/// The fits of a sparse grid of patches, every neighbour's brightness counting.
[[nodiscard]] std::vector<PatchFit> sample_patches(const PhotometricMaps& maps,
                                                   const LocalPlanes& planes,
                                                   float surface_tolerance_px);

/// Calls `take(y, x, fit)` for every known pixel, rows side by side.
void fit_patches(const PhotometricMaps& maps, const LocalPlanes& planes,
                 const PatchSettings& settings, const ForEach& for_each,
                 const std::function<void(int y, int x, const PatchFit&)>& take);

}  // namespace gripscan
