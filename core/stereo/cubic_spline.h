// Cubic B-spline interpolation (Unser 1999): the coefficients are computed once, then a value
// between the samples costs four taps. Much nearer to the true image than cubic convolution or
// OpenCV's remap (which rounds positions to 1/32 px), hence less pixel locking.
#pragma once

#include <opencv2/core/mat.hpp>

#include "core/base/for_each.h"

namespace gripscan {

/// Weights of the four coefficients at floor(x) − 1 … floor(x) + 2 for t = x − floor(x).
struct SplineTaps {
    float w0, w1, w2, w3;
    explicit SplineTaps(float t) {
        const float s = 1.0F - t;
        w0 = s * s * s * (1.0F / 6.0F);
        w3 = t * t * t * (1.0F / 6.0F);
        w1 = (2.0F / 3.0F) - 0.5F * t * t * (2.0F - t);
        w2 = (2.0F / 3.0F) - 0.5F * s * s * (2.0F - s);
    }
};

/// Coefficients along the rows of a grey image, CV_32F, with `pad` mirrored columns on
/// either side. Interpolates in x only.
[[nodiscard]] cv::Mat row_spline(const cv::Mat& grey, int pad, const ForEach& for_each);

/// Coefficients in both directions, with `pad` mirrored pixels on every side.
[[nodiscard]] cv::Mat image_spline(const cv::Mat& grey, int pad, const ForEach& for_each);

}  // namespace gripscan
