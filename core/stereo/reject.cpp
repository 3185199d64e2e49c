#include "core/stereo/reject.h"

#include <cmath>
#include <opencv2/imgproc.hpp>
#include <vector>

#include "core/stereo/match.h"

namespace gripscan {
namespace {

cv::Mat disc(int radius_px) {
    const int size = 2 * radius_px + 1;
    return cv::getStructuringElement(cv::MORPH_ELLIPSE, cv::Size(size, size));
}

/// The connected pieces of a mask with more than `px` pixels.
cv::Mat1b large_pieces(const cv::Mat& mask, int px) {
    cv::Mat label, stats, centres;
    cv::connectedComponentsWithStats(mask, label, stats, centres, 4);
    cv::Mat1b large(mask.size(), uchar{0});
    for (int y = 0; y < mask.rows; ++y) {
        for (int x = 0; x < mask.cols; ++x) {
            const int piece = label.at<int>(y, x);
            if (piece > 0 && stats.at<int>(piece, cv::CC_STAT_AREA) > px) large(y, x) = 255;
        }
    }
    return large;
}

/// 255 where the surface ends: at steps, and outside of it except for holes too small to hide a
/// rim.
cv::Mat1b surface_ends(const cv::Mat& disparity, const RejectSettings& settings) {
    cv::Mat1b known(disparity.size(), uchar{0});
    cv::Mat1b end(disparity.size(), uchar{0});
    const auto compare = [&](int y, int x, int y2, int x2) {
        const float difference = disparity.at<float>(y, x) - disparity.at<float>(y2, x2);
        if (std::isfinite(difference) && std::abs(difference) > settings.step_px) {
            end(y, x) = end(y2, x2) = 255;
        }
    };
    for (int y = 0; y < disparity.rows; ++y) {
        for (int x = 0; x < disparity.cols; ++x) {
            if (std::isfinite(disparity.at<float>(y, x))) known(y, x) = 255;
            if (x + 1 < disparity.cols) compare(y, x, y, x + 1);
            if (y + 1 < disparity.rows) compare(y, x, y + 1, x);
        }
    }
    end.setTo(255, large_pieces(known == 0, settings.max_hole_px));
    return end;
}

}  // namespace

void reject_silhouettes(cv::Mat& disparity, const RejectSettings& settings) {
    // Speckles first: a hole of one bad pixel should not grow.
    reject_islands(disparity, settings.min_island_px, settings.step_px);
    // Eroded by the rim, then opened: thin spikes of a fattened rim go too.
    cv::Mat kept = surface_ends(disparity, settings) == 0;
    const int spike_px = settings.rim_px + settings.spike_px;
    cv::erode(kept, kept, disc(spike_px), cv::Point(-1, -1), 1, cv::BORDER_CONSTANT, 0);
    cv::dilate(kept, kept, disc(settings.spike_px));
    disparity.setTo(cv::Scalar(kNoDisparity), kept == 0);
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
