#include "core/stereo/health.h"

#include <algorithm>
#include <cmath>
#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>
#include <optional>
#include <vector>

namespace gripscan {
namespace {

constexpr int kWindowPx = 9;
/// Local contrast from which a pixel counts as textured: twice the noise of an ordinary sensor.
constexpr float kTexturedLevels = 4.0F;
/// From here on a pixel counts as over-exposed: rectification smooths what the sensor cut off.
constexpr int kGlare = 250;

float median_of(std::vector<float>& values) {
    if (values.empty()) return 0.0F;
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

cv::Mat1f local_contrast(const cv::Mat& grey) {
    cv::Mat1f value;
    grey.convertTo(value, CV_32F);
    cv::Mat1f mean, square;
    cv::boxFilter(value, mean, -1, cv::Size(kWindowPx, kWindowPx));
    cv::sqrBoxFilter(value, square, CV_32F, cv::Size(kWindowPx, kWindowPx));
    cv::Mat1f contrast;
    cv::sqrt(cv::max(square - mean.mul(mean), 0.0F), contrast);
    return contrast;
}

/// Squared difference between two smoothings, pixel by pixel: structure of the sizes between.
cv::Mat band(const cv::Mat& grey, double fine_px, double coarse_px) {
    cv::Mat value, fine, coarse, squared;
    grey.convertTo(value, CV_32F);
    cv::GaussianBlur(value, fine, {}, fine_px);
    cv::GaussianBlur(value, coarse, {}, coarse_px);
    cv::subtract(fine, coarse, fine);
    cv::multiply(fine, fine, squared);
    return squared;
}

/// Over what stereo found and what surrounds it; saturated pixels have no structure of their own.
double sharpness_of(const cv::Mat& grey, const cv::Mat& disparity) {
    const cv::Mat fine = band(grey, 1.0, 2.0);
    const cv::Mat coarse = band(grey, 2.0, 4.0);
    double fine_sum = 0.0, coarse_sum = 0.0;
    for (int y = 0; y < grey.rows; ++y) {
        for (int x = 0; x < grey.cols; ++x) {
            if (!std::isfinite(disparity.at<float>(y, x))) continue;
            fine_sum += static_cast<double>(fine.at<float>(y, x));
            coarse_sum += static_cast<double>(coarse.at<float>(y, x));
        }
    }
    return coarse_sum > 0.0 ? std::sqrt(fine_sum / coarse_sum) : 0.0;
}

/// Vertical shift of the right image in the patch around (x, y), by one least-squares step.
/// Nothing where there is no vertical texture.
std::optional<float> row_shift(const StereoFrame& frame, int x, int y, float d) {
    constexpr int kHalf = 4;
    const int shift = static_cast<int>(std::floor(d));
    const float t = d - static_cast<float>(shift);
    const cv::Rect inside(kHalf + 1, kHalf + 1, frame.left.cols - 2 * kHalf - 2,
                          frame.left.rows - 2 * kHalf - 2);
    if (!inside.contains(cv::Point(x, y)) || !inside.contains(cv::Point(x - shift - 1, y)))
        return {};
    float gg = 0.0F, gr = 0.0F, g_sum = 0.0F, r_sum = 0.0F;
    for (int v = y - kHalf; v <= y + kHalf; ++v) {
        for (int u = x - kHalf; u <= x + kHalf; ++u) {
            const float right = (1.0F - t) * frame.right.at<uchar>(v, u - shift) +
                                t * frame.right.at<uchar>(v, u - shift - 1);
            const float r = right - static_cast<float>(frame.left.at<uchar>(v, u));
            const float g = 0.5F * static_cast<float>(frame.left.at<uchar>(v + 1, u) -
                                                      frame.left.at<uchar>(v - 1, u));
            gg += g * g;
            gr += g * r;
            g_sum += g;
            r_sum += r;
        }
    }
    constexpr float kCount = (2 * kHalf + 1) * (2 * kHalf + 1);
    const float information = gg - g_sum * g_sum / kCount;
    if (information < 10.0F * kCount) return {};
    // right(v) = left(v − shift) near the truth: r = −shift · dL/dv.
    return -(gr - g_sum * r_sum / kCount) / information;
}

}  // namespace

StereoHealth stereo_health(const StereoFrame& rectified, const cv::Rect& roi,
                           const cv::Mat& disparity) {
    const cv::Mat left = rectified.left(roi);
    const cv::Mat1f contrast = local_contrast(left);
    std::vector<float> contrasts;
    std::vector<float> surface_contrasts;
    std::vector<float> shifts;
    double textured = 0.0, found = 0.0, saturated = 0.0, glare = 0.0;
    for (int y = 0; y < roi.height; ++y) {
        for (int x = 0; x < roi.width; ++x) {
            const int grey = left.at<uchar>(y, x);
            const float d = disparity.at<float>(y, x);
            saturated += grey == 0 || grey == 255 ? 1.0 : 0.0;
            glare += grey >= kGlare ? 1.0 : 0.0;
            contrasts.push_back(contrast(y, x));
            if (std::isfinite(d)) surface_contrasts.push_back(contrast(y, x));
            if (contrast(y, x) < kTexturedLevels) continue;
            textured += 1.0;
            if (!std::isfinite(d)) continue;
            found += 1.0;
            if (x % 4 != 0 || y % 4 != 0) continue;
            if (const auto shift = row_shift(rectified, roi.x + x, roi.y + y, d)) {
                shifts.push_back(*shift);
            }
        }
    }
    StereoHealth health;
    health.fill = textured > 0.0 ? found / textured : 0.0;
    health.mean_intensity = cv::mean(left)[0];
    health.saturated = saturated / static_cast<double>(roi.area());
    health.texture = static_cast<double>(median_of(contrasts));
    health.glare = glare / static_cast<double>(roi.area());
    health.contrast = static_cast<double>(median_of(surface_contrasts));
    health.sharpness = sharpness_of(left, disparity);
    health.row_error_px = static_cast<double>(median_of(shifts));
    return health;
}

}  // namespace gripscan
