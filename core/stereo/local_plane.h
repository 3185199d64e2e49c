// Local planes of a disparity map. A plane in space is a plane in disparity, where the noise is
// uniform, so slants and normals are fitted there.
#pragma once

#include <opencv2/core/mat.hpp>

#include "core/base/for_each.h"

namespace gripscan {

/// Plane of the surface around every known pixel: disparity(x + dx, y + dy) ≈ value + slope_x·dx +
/// slope_y·dy. CV_32F maps of the disparity's size, zero where it is unknown.
struct LocalPlanes {
    cv::Mat value;    ///< px
    cv::Mat slope_x;  ///< px/px
    cv::Mat slope_y;
    cv::Mat support;  ///< sum of the weights; a lonely pixel has 1
};

struct PlaneSettings {
    int radius = 6;             ///< px; weights fall towards the rim
    float tolerance_px = 2.0F;  ///< pixels further from the plane belong to another surface
    /// At small steps and creases, where the window around a pixel fits badly, take the plane of a
    /// window beside it. Follows the surface closer, keeps more noise.
    bool look_beside = false;
    int rounds = 2;  ///< reweightings, each with half the tolerance of the one before
};

/// Robust (Tukey) weighted least squares per pixel. Unknown pixels are not finite.
[[nodiscard]] LocalPlanes fit_local_planes(const cv::Mat& disparity, const PlaneSettings& settings,
                                           const ForEach& for_each);

}  // namespace gripscan
