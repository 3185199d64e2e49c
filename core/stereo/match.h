// The first guess: OpenCV's semi-global matching, restricted to a search area.
#pragma once

#include <limits>

#include <opencv2/core/mat.hpp>

#include "core/camera/stereo_source.h"
#include "core/stereo/search_area.h"

namespace gripscan {

/// How an unknown disparity is written in every map of this folder.
inline constexpr float kNoDisparity = std::numeric_limits<float>::infinity();

/// Disparities of the area's roi (CV_32F, px, kNoDisparity where unknown), consistent between left
/// and right to a pixel, good to some tenths of a pixel (with pixel locking).
[[nodiscard]] cv::Mat match(const StereoFrame& rectified, const SearchArea& area);

}  // namespace gripscan
