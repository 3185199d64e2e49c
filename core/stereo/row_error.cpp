#include "core/stereo/row_error.h"

#include <algorithm>
#include <cmath>
#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>
#include <optional>
#include <vector>

#include "core/base/median.h"

namespace gripscan {
namespace {

constexpr int kApart_px = 8;         ///< between features
constexpr int kSamePlace_px = 2;     ///< around the best place: no other place
constexpr int kMostIterations = 12;  ///< of the sub-pixel placing
constexpr double kConverged_px = 5e-3;
constexpr double kMostMove_px = 1.5;  ///< further from the whole pixel: it ran away
constexpr double kSdOfMad = 1.4826;
constexpr double kSdOfMedian = 1.2533;

/// Corners of the area that are sharp in both directions, strongest first.
std::vector<cv::Point> features_of(const cv::Mat& left, const cv::Rect& roi,
                                   const RowErrorSettings& settings) {
    cv::Mat strength;
    constexpr int kBlock_px = 5;
    cv::cornerMinEigenVal(left(roi), strength, kBlock_px);
    // OpenCV sums over the block what Sobel gives (8 times the gradient) over 4 · block · 255: back
    // to the mean square of the gradient.
    constexpr double kScale = 4.0 * kBlock_px * 255.0 / 8.0;
    strength *= kScale * kScale / (kBlock_px * kBlock_px);
    cv::Mat best;
    cv::dilate(strength, best, {});
    std::vector<std::pair<float, cv::Point>> found;
    for (int y = 1; y + 1 < roi.height; ++y) {
        for (int x = 1; x + 1 < roi.width; ++x) {
            const float s = strength.at<float>(y, x);
            if (static_cast<double>(s) < settings.least_score || s < best.at<float>(y, x)) continue;
            found.emplace_back(s, roi.tl() + cv::Point(x, y));
        }
    }
    std::stable_sort(found.begin(), found.end(),
                     [](const auto& a, const auto& b) { return a.first > b.first; });
    std::vector<cv::Point> apart;
    cv::Mat1b taken(left.size(), 0);
    for (const auto& [s, at] : found) {
        if (taken(at) != 0) continue;
        cv::circle(taken, at, kApart_px, cv::Scalar(1), cv::FILLED);
        apart.push_back(at);
        if (static_cast<int>(apart.size()) >= settings.most_features) break;
    }
    return apart;
}

/// The largest of `match` outside the neighbourhood of `best`.
double runner_up(const cv::Mat& match, const cv::Point& best) {
    double second = -1.0;
    for (int y = 0; y < match.rows; ++y) {
        for (int x = 0; x < match.cols; ++x) {
            if (std::abs(x - best.x) <= kSamePlace_px && std::abs(y - best.y) <= kSamePlace_px) {
                continue;
            }
            second = std::max(second, static_cast<double>(match.at<float>(y, x)));
        }
    }
    return second;
}

/// Where the patch around `at` lies in the right image, to a pixel; nothing where that is not sure.
std::optional<cv::Point> coarse_place(const StereoFrame& frame, const SearchArea& area,
                                      const cv::Point& at, const RowErrorSettings& settings) {
    const int h = settings.half_patch_px;
    const cv::Rect whole(0, 0, frame.right.cols, frame.right.rows);
    const cv::Rect patch(at.x - h, at.y - h, 2 * h + 1, 2 * h + 1);
    const int far_x = at.x - area.min_disparity;
    const int near_x = far_x - area.num_disparities + 1;
    const cv::Rect band = cv::Rect(near_x - h, at.y - settings.band_px - h,
                                   far_x - near_x + 2 * h + 1, 2 * (settings.band_px + h) + 1) &
                          whole;
    if ((patch & whole) != patch || band.width < patch.width || band.height < patch.height) {
        return std::nullopt;
    }
    cv::Mat match;
    cv::matchTemplate(frame.right(band), frame.left(patch), match, cv::TM_CCOEFF_NORMED);
    double best = 0.0;
    cv::Point where;
    cv::minMaxLoc(match, nullptr, &best, nullptr, &where);
    if (best < settings.least_match || best - runner_up(match, where) < settings.unique_by) {
        return std::nullopt;
    }
    const int row = band.y + where.y + h;
    if (std::abs(row - at.y) >= settings.band_px) return std::nullopt;  // it may lie beyond
    return cv::Point(band.x + where.x + h, row);
}

struct Sums {
    double gxx = 0.0, gxy = 0.0, gyy = 0.0, gxr = 0.0, gyr = 0.0;
};

double bilinear(const cv::Mat& image, double x, double y) {
    const int x0 = static_cast<int>(std::floor(x));
    const int y0 = static_cast<int>(std::floor(y));
    const double tx = x - x0;
    const double ty = y - y0;
    const auto* a = image.ptr<uchar>(y0) + x0;
    const auto* b = image.ptr<uchar>(y0 + 1) + x0;
    return (1.0 - ty) * ((1.0 - tx) * a[0] + tx * a[1]) + ty * ((1.0 - tx) * b[0] + tx * b[1]);
}

/// One least-squares equation of the move that makes the patches alike; brightness may differ by a
/// constant.
Sums sums_at(const StereoFrame& frame, const cv::Point& at, double x, double y, int h) {
    const int count = (2 * h + 1) * (2 * h + 1);
    Sums sums;
    double gx_sum = 0.0, gy_sum = 0.0, r_sum = 0.0;
    for (int v = -h; v <= h; ++v) {
        const auto* row = frame.left.ptr<uchar>(at.y + v);
        const auto* above = frame.left.ptr<uchar>(at.y + v - 1);
        const auto* below = frame.left.ptr<uchar>(at.y + v + 1);
        for (int u = -h; u <= h; ++u) {
            const int c = at.x + u;
            const double gx = 0.5 * (row[c + 1] - row[c - 1]);
            const double gy = 0.5 * (below[c] - above[c]);
            const double r = row[c] - bilinear(frame.right, x + u, y + v);
            sums.gxx += gx * gx;
            sums.gxy += gx * gy;
            sums.gyy += gy * gy;
            sums.gxr += gx * r;
            sums.gyr += gy * r;
            gx_sum += gx;
            gy_sum += gy;
            r_sum += r;
        }
    }
    sums.gxx -= gx_sum * gx_sum / count;
    sums.gxy -= gx_sum * gy_sum / count;
    sums.gyy -= gy_sum * gy_sum / count;
    sums.gxr -= gx_sum * r_sum / count;
    sums.gyr -= gy_sum * r_sum / count;
    return sums;
}

/// Its row in the right image to parts of a pixel; nothing where the placing does not settle.
std::optional<double> fine_row(const StereoFrame& frame, const cv::Point& at,
                               const cv::Point& coarse, int h) {
    double x = coarse.x;
    double y = coarse.y;
    for (int i = 0; i < kMostIterations; ++i) {
        const cv::Rect2d inside(h + 1, h + 1, frame.right.cols - 2 * h - 3,
                                frame.right.rows - 2 * h - 3);
        if (!inside.contains(cv::Point2d(x, y)) || !inside.contains(cv::Point2d(at))) return {};
        const Sums s = sums_at(frame, at, x, y, h);
        const double det = s.gxx * s.gyy - s.gxy * s.gxy;
        if (det <= 1e-6 * s.gxx * s.gyy) return {};
        const double dx = (s.gyy * s.gxr - s.gxy * s.gyr) / det;
        const double dy = (s.gxx * s.gyr - s.gxy * s.gxr) / det;
        x += dx;
        y += dy;
        if (std::hypot(x - coarse.x, y - coarse.y) > kMostMove_px) return {};
        if (std::hypot(dx, dy) < kConverged_px) return y;
    }
    return {};
}

}  // namespace

Result<RowError> measure_row_error(const StereoFrame& rectified, const SearchArea& area,
                                   const RowErrorSettings& settings, const std::stop_token& stop) {
    const auto features = features_of(rectified.left, area.roi, settings);
    const auto least = static_cast<std::size_t>(settings.least_features);
    if (features.size() < least) {
        return input_error(
            "{} features in the registration area, {} are needed: too little texture",
            features.size(), least);
    }
    std::vector<double> shifts;
    for (const cv::Point& at : features) {
        if (stop.stop_requested()) return cancelled_error();
        const auto coarse = coarse_place(rectified, area, at, settings);
        if (!coarse) continue;
        const auto row = fine_row(rectified, at, *coarse, settings.half_patch_px);
        if (row) shifts.push_back(*row - at.y);
    }
    if (shifts.size() < least) {
        return input_error(
            "{} of {} features were found in the right image within {} rows, {} are needed",
            shifts.size(), features.size(), settings.band_px, least);
    }
    RowError error;
    error.median_px = median_of(shifts);
    error.features = static_cast<int>(shifts.size());
    std::vector<double> away = shifts;
    for (double& value : away) value = std::abs(value - error.median_px);
    error.sd_px = kSdOfMedian * kSdOfMad * median_of(std::move(away)) /
                  std::sqrt(static_cast<double>(shifts.size()));
    return error;
}

}  // namespace gripscan
