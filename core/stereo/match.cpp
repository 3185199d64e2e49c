#include "core/stereo/match.h"

#include <algorithm>
#include <opencv2/calib3d.hpp>
#include <opencv2/core.hpp>

namespace gripscan {
namespace {

constexpr int kBlockPx = 5;
constexpr int kFixedPoint = 16;  ///< SGBM counts in sixteenths of a pixel

/// Columns [x0, x1) and the rows of the roi; the border pixel is repeated outside the image.
cv::Mat window(const cv::Mat& image, const cv::Rect& roi, int x0, int x1) {
    const int left = std::max(0, -x0);
    const int right = std::max(0, x1 - image.cols);
    const cv::Mat inside = image(cv::Rect(x0 + left, roi.y, x1 - right - (x0 + left), roi.height));
    cv::Mat padded;
    cv::copyMakeBorder(inside, padded, 0, 0, left, right, cv::BORDER_REPLICATE);
    return padded;
}

cv::Ptr<cv::StereoSGBM> matcher(const SearchArea& area) {
    return cv::StereoSGBM::create(area.min_disparity, area.num_disparities, kBlockPx,
                                  8 * kBlockPx * kBlockPx, 32 * kBlockPx * kBlockPx,
                                  /*disp12MaxDiff=*/1, /*preFilterCap=*/0, /*uniquenessRatio=*/5,
                                  /*speckleWindowSize=*/0, /*speckleRange=*/0,
                                  cv::StereoSGBM::MODE_SGBM_3WAY);
}

}  // namespace

cv::Mat match(const StereoFrame& rectified, const SearchArea& area) {
    const cv::Rect& roi = area.roi;
    const int highest = area.min_disparity + area.num_disparities;
    // SGBM gives nothing for the first `highest` columns: let them lie left of the roi.
    const int x0 = roi.x - std::max(0, highest);
    const int x1 = roi.x + roi.width + std::max(0, -area.min_disparity);
    cv::Mat sixteenths;
    matcher(area)->compute(window(rectified.left, roi, x0, x1),
                           window(rectified.right, roi, x0, x1), sixteenths);
    cv::Mat disparity(roi.size(), CV_32F);
    const float last = static_cast<float>(rectified.right.cols - 1);
    for (int y = 0; y < roi.height; ++y) {
        const auto* from = sixteenths.ptr<short>(y) + (roi.x - x0);
        auto* to = disparity.ptr<float>(y);
        for (int x = 0; x < roi.width; ++x) {
            const float d = static_cast<float>(from[x]) / kFixedPoint;
            const float x_right = static_cast<float>(roi.x + x) - d;
            const bool known =
                from[x] >= area.min_disparity * kFixedPoint && x_right >= 0.0F && x_right <= last;
            to[x] = known ? d : kNoDisparity;
        }
    }
    return disparity;
}

}  // namespace gripscan
