#include "core/stereo/reject.h"

#include <cmath>
#include <opencv2/imgproc.hpp>
#include <vector>

#include "core/stereo/match.h"

namespace gripscan {
namespace {

/// 1 where a pixel is unknown or lies on either side of a step.
cv::Mat1b edges(const cv::Mat& disparity, float step_px) {
    cv::Mat1b edge(disparity.size(), uchar{0});
    const auto compare = [&](int y, int x, int y2, int x2) {
        const float a = disparity.at<float>(y, x);
        const float b = disparity.at<float>(y2, x2);
        if (std::isfinite(a) && std::isfinite(b) && std::abs(a - b) > step_px) {
            edge(y, x) = edge(y2, x2) = 1;
        }
    };
    for (int y = 0; y < disparity.rows; ++y) {
        for (int x = 0; x < disparity.cols; ++x) {
            if (!std::isfinite(disparity.at<float>(y, x))) edge(y, x) = 1;
            if (x + 1 < disparity.cols) compare(y, x, y, x + 1);
            if (y + 1 < disparity.rows) compare(y, x, y + 1, x);
        }
    }
    return edge;
}

}  // namespace

void reject_silhouettes(cv::Mat& disparity, const RejectSettings& settings) {
    // Speckles first: a hole of one bad pixel should not grow.
    reject_islands(disparity, settings.min_island_px, settings.step_px);
    cv::Mat1b near_edge;
    const cv::Mat disc = cv::getStructuringElement(
        cv::MORPH_ELLIPSE, cv::Size(2 * settings.rim_px + 1, 2 * settings.rim_px + 1));
    cv::dilate(edges(disparity, settings.step_px), near_edge, disc);
    disparity.setTo(cv::Scalar(kNoDisparity), near_edge);
    reject_islands(disparity, settings.min_island_px, settings.step_px);
}

void reject_islands(cv::Mat& disparity, int min_px, float step_px) {
    cv::Mat1i label(disparity.size(), 0);
    std::vector<cv::Point> island;
    int labels = 0;
    const cv::Rect all(0, 0, disparity.cols, disparity.rows);
    for (int y = 0; y < disparity.rows; ++y) {
        for (int x = 0; x < disparity.cols; ++x) {
            if (label(y, x) != 0 || !std::isfinite(disparity.at<float>(y, x))) continue;
            island.assign(1, cv::Point(x, y));
            label(y, x) = ++labels;
            for (std::size_t next = 0; next < island.size(); ++next) {
                const cv::Point p = island[next];
                const float d = disparity.at<float>(p);
                for (const cv::Point step :
                     {cv::Point(1, 0), cv::Point(-1, 0), cv::Point(0, 1), cv::Point(0, -1)}) {
                    const cv::Point q = p + step;
                    if (!all.contains(q) || label(q) != 0) continue;
                    if (!(std::abs(disparity.at<float>(q) - d) <= step_px)) continue;
                    label(q) = labels;
                    island.push_back(q);
                }
            }
            if (static_cast<int>(island.size()) >= min_px) continue;
            for (const cv::Point p : island) disparity.at<float>(p) = kNoDisparity;
        }
    }
}

}  // namespace gripscan
