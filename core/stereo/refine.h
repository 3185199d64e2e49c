// Sub-pixel refinement of a disparity map against pixel locking: Gauss–Newton on grey patches.
//
// The disparities are smoothed by local planes (d), the right image is sampled there, and every
// pixel q near p gives one linear equation for p's correction, from the difference in brightness:
//     R(x − d_q) − L = G·correction + offset + gain·L,      G = dL/dx / (1 − slope_x)
// So the patch follows slant and curvature, brightness may differ between the cameras, and
// neighbours of another surface or with another brightness (occlusion) lose their weight. The
// derivative comes from the left image at whole pixels: its noise is then independent of the
// interpolated one, and noise pulls towards no fraction of a pixel.
#pragma once

#include <opencv2/core/mat.hpp>

#include "core/base/for_each.h"
#include "core/camera/stereo_source.h"

namespace gripscan {

struct RefineSettings {
    int radius = 6;            ///< of the patch, px; weights fall towards the rim
    bool look_beside = false;  ///< see PlaneSettings
    int iterations = 3;
    float max_move_px = 1.5F;       ///< further from the first guess: not this surface
    float max_sigma_px = 0.25F;     ///< predicted; above: too little texture
    float min_inliers = 0.5F;       ///< share of the patch whose brightness fits
    float max_lever_px = 2.0F;      ///< distance of the texture's centre from the pixel …
    float max_gap_lever_px = 4.5F;  ///< … and where the texture is around, but sparse
    int max_gap_px = 5;             ///< half the width of a gap in the texture that is bridged
    float max_unexplained = 0.7F;   ///< residual in units of the patch's contrast
    float min_texture_to_noise = 1.0F;
    float systematic_px = 0.02F;  ///< floor of sigma: what averaging does not remove
};

/// Maps of the roi, CV_32F. `disparity` and `sigma` (px, one standard deviation) are kNoDisparity
/// where the images do not support the pixel.
struct Refined {
    cv::Mat disparity;
    cv::Mat sigma;
};

/// `first_guess` covers `roi` of the left image.
[[nodiscard]] Refined refine_disparity(const StereoFrame& rectified, const cv::Rect& roi,
                                       const cv::Mat& first_guess, const RefineSettings& settings,
                                       const ForEach& for_each);

}  // namespace gripscan
