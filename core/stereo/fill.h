// Dense disparity: fills what matching left open. For images, not for clouds.
#pragma once

#include <opencv2/core/mat.hpp>

namespace gripscan {

/// Every unknown pixel takes the further of the nearest known disparities to its left and right
/// (what is hidden from one camera lies behind), then smooths over the filled pixels. Rows without
/// any known pixel take the row above or below.
void fill_holes(cv::Mat& disparity);

}  // namespace gripscan
