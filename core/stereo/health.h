// How well a stereo pair could be used.
#pragma once

#include <opencv2/core/mat.hpp>

#include "core/camera/stereo_source.h"
#include "core/stereo/stereo_cloud.h"

namespace gripscan {

/// `disparity` (CV_32F, kNoDisparity where unknown) covers `roi` of the left image.
[[nodiscard]] StereoHealth stereo_health(const StereoFrame& rectified, const cv::Rect& roi,
                                         const cv::Mat& disparity);

}  // namespace gripscan
