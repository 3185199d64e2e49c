// The brightness of both images as the refinement compares them: the right image sampled at the
// current disparities, with differences of exposure and vignetting between the cameras taken out.
#pragma once

#include <opencv2/core/mat.hpp>

#include "core/base/for_each.h"
#include "core/camera/stereo_source.h"

namespace gripscan {

/// Variance that the smoothing of the images leaves of white noise. As it also correlates
/// neighbouring residuals, a patch knows no more than with the raw noise.
inline constexpr float kNoiseKept = 0.41F;
/// Variance of the gradient that noise makes, in units of the residual's variance.
inline constexpr float kGradientNoise = 0.6F;

/// What the patches read, CV_32F, padded by `pad` on every side.
struct PhotometricMaps {
    cv::Mat left;       ///< brightness, levels
    cv::Mat gradient;   ///< its x-derivative, levels/px
    cv::Mat disparity;  ///< current, px; 0 where unknown
    cv::Mat known;      ///< 1 or 0
    cv::Mat residual;   ///< right image at the current disparity minus left, levels
    int pad = 0;
    cv::Size size;

    PhotometricMaps(cv::Size roi, int padding);
};

class Photometry {
  public:
    Photometry(const StereoFrame& rectified, const cv::Rect& roi, int pad, const ForEach& for_each);

    [[nodiscard]] const PhotometricMaps& maps() const { return maps_; }

    /// Residuals of every known pixel at `disparity` (of the roi, not finite where unknown).
    void sample_right(const cv::Mat& disparity, const ForEach& for_each);
    /// Divides the right image by 1 + `gain`; takes effect with the next sample_right().
    void take_out_gain(float gain);
    /// Subtracts the local mean of the residuals; those further than `limit_levels` from it, which
    /// belong to wrong matches, do not count.
    void take_out_offset(float limit_levels);

  private:
    PhotometricMaps maps_;
    cv::Rect roi_;
    cv::Mat right_spline_;
    float last_x_;
};

}  // namespace gripscan
