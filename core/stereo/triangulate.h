// From disparities to an organised cloud with normals, intensities and standard deviations.
#pragma once

#include <opencv2/core/mat.hpp>
#include <optional>

#include "core/base/for_each.h"
#include "core/cloud/cloud.h"
#include "core/geometry/box.h"
#include "core/geometry/stereo_rig.h"

namespace gripscan {

/// `disparity` and `sigma` (px, CV_32F) cover `roi` of the left image `grey`; the cloud's grid is
/// the whole image. Points with a grazing or unclear normal, and those outside `keep`, are left
/// out.
[[nodiscard]] Cloud triangulate(const cv::Mat& disparity, const cv::Mat& sigma, const cv::Rect& roi,
                                const cv::Mat& grey, const RectifiedRig& rig,
                                const std::optional<Box>& keep, const ForEach& for_each);

}  // namespace gripscan
