#include "core/stereo/cubic_spline.h"

#include <cmath>
#include <opencv2/core.hpp>
#include <vector>

namespace gripscan {
namespace {

/// Pole of the recursive filter that turns samples into coefficients.
const float kPole = static_cast<float>(std::sqrt(3.0) - 2.0);
/// kPole to this power is below the resolution of a float.
constexpr int kHorizon = 14;

/// Samples to coefficients, in place, mirrored at both ends.
void filter_line(float* c, int n) {
    if (n < 2) return;
    float sum = c[0];
    float power = kPole;
    for (int i = 1; i < std::min(n, kHorizon); ++i) {
        sum += power * c[i];
        power *= kPole;
    }
    c[0] = sum;
    for (int i = 1; i < n; ++i) c[i] += kPole * c[i - 1];
    c[n - 1] = kPole / (kPole * kPole - 1.0F) * (c[n - 1] + kPole * c[n - 2]);
    for (int i = n - 2; i >= 0; --i) c[i] = kPole * (c[i + 1] - c[i]);
    for (int i = 0; i < n; ++i) c[i] *= 6.0F;
}

}  // namespace

cv::Mat row_spline(const cv::Mat& grey, int pad, const ForEach& for_each) {
    cv::Mat line;
    grey.convertTo(line, CV_32F);
    for_each(static_cast<std::size_t>(line.rows),
             [&](std::size_t y) { filter_line(line.ptr<float>(static_cast<int>(y)), line.cols); });
    cv::Mat padded;
    cv::copyMakeBorder(line, padded, 0, 0, pad, pad, cv::BORDER_REFLECT_101);
    return padded;
}

cv::Mat image_spline(const cv::Mat& grey, int pad, const ForEach& for_each) {
    const cv::Mat rows = row_spline(grey, 0, for_each);
    cv::Mat columns = rows.t();
    for_each(static_cast<std::size_t>(columns.rows), [&](std::size_t x) {
        filter_line(columns.ptr<float>(static_cast<int>(x)), columns.cols);
    });
    cv::Mat padded;
    cv::copyMakeBorder(columns.t(), padded, pad, pad, pad, pad, cv::BORDER_REFLECT_101);
    return padded;
}

}  // namespace gripscan
