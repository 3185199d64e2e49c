// Takes away what would be a flying pixel in the cloud: rims of surfaces, islands, grazing views.
#pragma once

#include <opencv2/core/mat.hpp>

namespace gripscan {

struct RejectSettings {
    float step_px = 0.7F;     ///< a larger step between neighbours, beyond the slant, is an edge
    int rim_px = 1;           ///< pixels as near to the end of a surface are dropped
    int spike_px = 1;         ///< half the width of what counts as a spike on the rim
    int max_hole_px = 40;     ///< holes of fewer pixels within a surface are no edge
    int min_island_px = 150;  ///< smaller connected surfaces are dropped
};

/// Sets what fails to kNoDisparity in `disparity` (CV_32F).
void reject_silhouettes(cv::Mat& disparity, const RejectSettings& settings);

/// Islands of fewer than `min_px` connected pixels (steps up to `step_px`) become kNoDisparity.
void reject_islands(cv::Mat& disparity, int min_px, float step_px);

}  // namespace gripscan
