// What part of the left image, and which disparities, the registration area can produce.
#pragma once

#include <opencv2/core/types.hpp>
#include <optional>

#include "core/base/result.h"
#include "core/geometry/box.h"
#include "core/geometry/stereo_rig.h"
#include "core/stereo/stereo_cloud.h"

namespace gripscan {

/// Disparities in [min_disparity, min_disparity + num_disparities), px; the count is a multiple of
/// 16. `roi` lies in the left image.
struct SearchArea {
    cv::Rect roi;
    int min_disparity = 0;
    int num_disparities = 0;
};

/// Without a region: the whole image. Errors: a region that is empty, lies behind the camera or
/// outside the image; disparities that make no sense.
[[nodiscard]] Result<SearchArea> search_area(const RectifiedRig& rig,
                                             const std::optional<Box>& region,
                                             const StereoSettings& settings);

}  // namespace gripscan
