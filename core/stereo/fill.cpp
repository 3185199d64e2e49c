#include "core/stereo/fill.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "core/stereo/match.h"

namespace gripscan {
namespace {

void fill_row(float* d, int n) {
    int x = 0;
    while (x < n) {
        if (std::isfinite(d[x])) {
            ++x;
            continue;
        }
        int end = x;
        while (end < n && !std::isfinite(d[end])) ++end;
        const float left = x > 0 ? d[x - 1] : kNoDisparity;
        const float right = end < n ? d[end] : kNoDisparity;
        std::fill(d + x, d + end, std::min(left, right));  // unknown is +inf: the other one wins
        x = end;
    }
}

}  // namespace

void fill_holes(cv::Mat& disparity) {
    cv::Mat1b unknown(disparity.size());
    for (int y = 0; y < disparity.rows; ++y) {
        auto* d = disparity.ptr<float>(y);
        for (int x = 0; x < disparity.cols; ++x) unknown(y, x) = std::isfinite(d[x]) ? 0 : 255;
        fill_row(d, disparity.cols);
    }
    for (int y = 1; y < disparity.rows; ++y) {
        if (!std::isfinite(disparity.at<float>(y, 0))) {
            disparity.row(y - 1).copyTo(disparity.row(y));
        }
    }
    for (int y = disparity.rows - 2; y >= 0; --y) {
        if (!std::isfinite(disparity.at<float>(y, 0))) {
            disparity.row(y + 1).copyTo(disparity.row(y));
        }
    }
    cv::Mat smooth;
    cv::medianBlur(disparity, smooth, 5);
    smooth.copyTo(disparity, unknown);
}

}  // namespace gripscan
