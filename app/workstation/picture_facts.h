// Numbers and pictures that the window shows beside a capture, cheap enough for live images.
#pragma once

#include <opencv2/core/mat.hpp>
#include <optional>

#include "core/cloud/cloud.h"
#include "core/geometry/box.h"
#include "core/geometry/stereo_rig.h"
#include "core/stereo/stereo_cloud.h"

namespace gripscan::app {

/// Brightness and saturation of a rectified image where the registration area can be seen; what
/// only a matched pair can tell is no number.
[[nodiscard]] StereoHealth exposure_of(const cv::Mat& image, const RectifiedRig& rig,
                                       const std::optional<Box>& region);

/// The disparities that an organised cloud came from: CV_32F of the rig's size, +inf where there is
/// no point. Empty for a cloud without a grid of that size.
[[nodiscard]] cv::Mat disparity_of(const Cloud& cloud, const RectifiedRig& rig);

}  // namespace gripscan::app
