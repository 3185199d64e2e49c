#include "core/stereo/refine.h"

#include <algorithm>
#include <opencv2/core.hpp>

#include "core/stereo/cubic_spline.h"
#include "core/stereo/local_plane.h"
#include "core/stereo/match.h"
#include "core/stereo/photometric_fit.h"

namespace gripscan {
namespace {

constexpr int kSplinePad = 4;
/// Tukey's limit for 95 % efficiency under normal noise.
constexpr float kTukey = 4.7F;

/// Value of the right image at (x, row of `c`).
float sample(const float* c, float x) {
    const int i = static_cast<int>(x);
    const SplineTaps taps(x - static_cast<float>(i));
    const float* s = c + i + kSplinePad - 1;
    return taps.w0 * s[0] + taps.w1 * s[1] + taps.w2 * s[2] + taps.w3 * s[3];
}

/// Brightness and x-derivative of the left image in the roi.
void fill_left(const cv::Mat& left, const cv::Rect& roi, const ForEach& for_each,
               PhotometricMaps& maps) {
    const cv::Mat c = row_spline(left.rowRange(roi.y, roi.y + roi.height), kSplinePad, for_each);
    for (int y = 0; y < roi.height; ++y) {
        const auto* grey = left.ptr<uchar>(roi.y + y) + roi.x;
        const auto* s = c.ptr<float>(y) + roi.x + kSplinePad;
        auto* value = maps.left.ptr<float>(y + maps.pad) + maps.pad;
        auto* slope = maps.gradient.ptr<float>(y + maps.pad) + maps.pad;
        for (int x = 0; x < roi.width; ++x) {
            value[x] = static_cast<float>(grey[x]);
            slope[x] = 0.5F * (s[x + 1] - s[x - 1]);
        }
    }
}

/// Brightness difference of every known pixel at its current disparity.
void fill_residuals(const cv::Mat& right_spline, const cv::Rect& roi, const cv::Mat& disparity,
                    const ForEach& for_each, PhotometricMaps& maps) {
    const float last = static_cast<float>(right_spline.cols - 2 * kSplinePad - 1);
    for_each(static_cast<std::size_t>(roi.height), [&](std::size_t row) {
        const int y = static_cast<int>(row);
        const auto* c = right_spline.ptr<float>(y);
        const auto* d = disparity.ptr<float>(y);
        const auto* left = maps.left.ptr<float>(y + maps.pad) + maps.pad;
        auto* kept = maps.disparity.ptr<float>(y + maps.pad) + maps.pad;
        auto* known = maps.known.ptr<float>(y + maps.pad) + maps.pad;
        auto* residual = maps.residual.ptr<float>(y + maps.pad) + maps.pad;
        for (int x = 0; x < roi.width; ++x) {
            const float x_right = static_cast<float>(roi.x + x) - d[x];
            const bool inside = x_right >= 0.0F && x_right <= last;  // false for unknown ones
            known[x] = inside ? 1.0F : 0.0F;
            kept[x] = inside ? d[x] : 0.0F;
            residual[x] = inside ? sample(c, x_right) - left[x] : 0.0F;
        }
    });
}

/// Scale of the brightness residuals where the match is good: the lower quartile of the patches'
/// rms, so that wrong matches, of which there may be many, do not count.
float noise_level(std::vector<float> values) {
    constexpr float kQuantisation = 0.5F;  // levels; two 8-bit images
    if (values.empty()) return kQuantisation;
    const auto quartile = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 4);
    std::nth_element(values.begin(), quartile, values.end());
    return std::max(*quartile, kQuantisation);
}

bool supported(const PatchFit& fit, float move_px, float sigma_px, const RefineSettings& s) {
    return std::abs(move_px) <= s.max_move_px && sigma_px <= s.max_sigma_px &&
           fit.inliers >= s.min_inliers && fit.lever_px <= s.max_lever_px;
}

}  // namespace

Refined refine_disparity(const StereoFrame& rectified, const cv::Rect& roi,
                         const cv::Mat& first_guess, const RefineSettings& settings,
                         const ForEach& for_each) {
    PhotometricMaps maps(roi.size(), settings.radius);
    fill_left(rectified.left, roi, for_each, maps);
    const cv::Mat right_spline =
        row_spline(rectified.right.rowRange(roi.y, roi.y + roi.height), kSplinePad, for_each);
    Refined out{first_guess.clone(), cv::Mat(roi.size(), CV_32F, cv::Scalar(kNoDisparity))};
    const int last = settings.iterations - 1;
    float tolerance_px = 1.5F;
    for (int iteration = 0; iteration <= last; ++iteration) {
        PlaneSettings plane_settings;
        plane_settings.radius = settings.radius;
        const LocalPlanes planes = fit_local_planes(out.disparity, plane_settings, for_each);
        fill_residuals(right_spline, roi, out.disparity, for_each, maps);
        const float noise = noise_level(patch_rms(maps, planes));
        const PatchSettings patch{tolerance_px, kTukey * noise};
        const cv::Mat current = out.disparity.clone();
        fit_patches(maps, planes, patch, for_each, [&](int y, int x, const PatchFit& fit) {
            const float d = current.at<float>(y, x);
            const float step = std::clamp(fit.step_px, -0.75F, 0.75F);
            out.disparity.at<float>(y, x) = d + step;
            if (iteration < last) return;
            const float sigma = std::hypot(fit.sigma_px, settings.systematic_px);
            const bool ok = supported(fit, d + step - first_guess.at<float>(y, x), sigma, settings);
            out.disparity.at<float>(y, x) = ok ? d + step : kNoDisparity;
            out.sigma.at<float>(y, x) = ok ? sigma : kNoDisparity;
        });
        tolerance_px = std::max(0.75F, 0.7F * tolerance_px);
    }
    return out;
}

}  // namespace gripscan
