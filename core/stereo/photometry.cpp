#include "core/stereo/photometry.h"

#include <algorithm>
#include <opencv2/imgproc.hpp>
#include <vector>

#include "core/stereo/cubic_spline.h"
#include "core/stereo/pixel_window.h"

namespace gripscan {
namespace {

constexpr int kSplinePad = 4;
constexpr double kSmoothingPx = 0.5;
/// Side of the window over which the cameras' exposures may differ by one offset.
constexpr int kOffsetWindowPx = 21;

/// The rows of the roi, slightly smoothed: the highest frequencies hold more noise than texture,
/// and what the sensor has aliased would pull towards whole pixels.
cv::Mat smoothed(const cv::Mat& grey, const cv::Rect& roi) {
    cv::Mat value, smooth;
    grey.rowRange(roi.y, roi.y + roi.height).convertTo(value, CV_32F);
    cv::GaussianBlur(value, smooth, {}, kSmoothingPx, kSmoothingPx, cv::BORDER_REFLECT);
    return smooth;
}

/// Value of the right image at column x of the row with coefficients `c`.
float sample(const float* c, float x) {
    const int i = static_cast<int>(x);
    const SplineTaps taps(x - static_cast<float>(i));
    const float* s = c + i + kSplinePad - 1;
    return taps.w0 * s[0] + taps.w1 * s[1] + taps.w2 * s[2] + taps.w3 * s[3];
}

float median_where_known(const cv::Mat& value, const cv::Mat& known) {
    std::vector<float> values;
    for (int y = 0; y < value.rows; y += 2) {
        for (int x = 0; x < value.cols; ++x) {
            if (known.at<float>(y, x) > 0.0F) values.push_back(value.at<float>(y, x));
        }
    }
    if (values.empty()) return 0.0F;
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

}  // namespace

PhotometricMaps::PhotometricMaps(cv::Size roi, int padding) : pad(padding), size(roi) {
    for (cv::Mat* m : {&left, &gradient, &disparity, &known, &residual}) {
        *m = padded_map(cv::Mat::zeros(roi, CV_32F), pad, 0.0F);
    }
}

Photometry::Photometry(const StereoFrame& rectified, const cv::Rect& roi, int pad,
                       const ForEach& for_each)
    : maps_(roi.size(), pad),
      roi_(roi),
      right_spline_(row_spline(smoothed(rectified.right, roi), kSplinePad, for_each)),
      last_x_(static_cast<float>(rectified.right.cols - 1)) {
    const cv::Mat left = smoothed(rectified.left, roi);
    const cv::Mat c = row_spline(left, kSplinePad, for_each);
    for (int y = 0; y < roi.height; ++y) {
        const auto* grey = left.ptr<float>(y) + roi.x;
        const auto* s = c.ptr<float>(y) + roi.x + kSplinePad;
        auto* value = maps_.left.ptr<float>(y + pad) + pad;
        auto* slope = maps_.gradient.ptr<float>(y + pad) + pad;
        for (int x = 0; x < roi.width; ++x) {
            value[x] = grey[x];
            slope[x] = 0.5F * (s[x + 1] - s[x - 1]);
        }
    }
}

void Photometry::sample_right(const cv::Mat& disparity, const ForEach& for_each) {
    for_each(static_cast<std::size_t>(roi_.height), [&](std::size_t row) {
        const int y = static_cast<int>(row);
        const int pad = maps_.pad;
        const auto* c = right_spline_.ptr<float>(y);
        const auto* d = disparity.ptr<float>(y);
        const auto* left = maps_.left.ptr<float>(y + pad) + pad;
        auto* kept = maps_.disparity.ptr<float>(y + pad) + pad;
        auto* known = maps_.known.ptr<float>(y + pad) + pad;
        auto* residual = maps_.residual.ptr<float>(y + pad) + pad;
        for (int x = 0; x < roi_.width; ++x) {
            const float x_right = static_cast<float>(roi_.x + x) - d[x];
            const bool inside = x_right >= 0.0F && x_right <= last_x_;  // false for unknown ones
            known[x] = inside ? 1.0F : 0.0F;
            kept[x] = inside ? d[x] : 0.0F;
            residual[x] = inside ? sample(c, x_right) - left[x] : 0.0F;
        }
    });
}

void Photometry::take_out_gain(float gain) {
    right_spline_ *= 1.0 / (1.0 + static_cast<double>(gain));
}

void Photometry::take_out_offset(float limit_levels) {
    cv::Mat offset(maps_.residual.size(), CV_32F,
                   cv::Scalar(median_where_known(maps_.residual, maps_.known)));
    const cv::Size window(kOffsetWindowPx, kOffsetWindowPx);
    for (const float limit : {3.0F * limit_levels, limit_levels}) {
        cv::Mat weight(offset.size(), CV_32F);
        cv::Mat weighted(offset.size(), CV_32F);
        for (int y = 0; y < offset.rows; ++y) {
            const auto* r = maps_.residual.ptr<float>(y);
            const auto* o = offset.ptr<float>(y);
            const auto* known = maps_.known.ptr<float>(y);
            for (int x = 0; x < offset.cols; ++x) {
                const float beside = (r[x] - o[x]) / limit;
                const float keep = std::max(0.0F, 1.0F - beside * beside);
                weight.at<float>(y, x) = known[x] * keep * keep;
                weighted.at<float>(y, x) = weight.at<float>(y, x) * r[x];
            }
        }
        cv::boxFilter(weight, weight, -1, window, {-1, -1}, true, cv::BORDER_CONSTANT);
        cv::boxFilter(weighted, weighted, -1, window, {-1, -1}, true, cv::BORDER_CONSTANT);
        // Where hardly anything fits, the offset of before stays.
        constexpr float kAnchor = 0.02F;
        offset = (weighted + kAnchor * offset) / (weight + kAnchor);
    }
    maps_.residual = (maps_.residual - offset).mul(maps_.known);
}

}  // namespace gripscan
