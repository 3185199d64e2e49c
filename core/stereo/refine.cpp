#include "core/stereo/refine.h"

#include <algorithm>
#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>

#include "core/stereo/cubic_spline.h"
#include "core/stereo/local_plane.h"
#include "core/stereo/match.h"
#include "core/stereo/photometric_fit.h"

namespace gripscan {
namespace {

constexpr int kSplinePad = 4;
/// Tukey's limit for 95 % efficiency under normal noise.
constexpr float kTukey = 4.7F;
constexpr double kSmoothingPx = 0.5;
/// The smoothing takes this share of the variance of white noise; as it also correlates
/// neighbouring residuals, a patch knows no more than with the raw noise.
constexpr float kNoiseKept = 0.41F;

/// The rows of the roi, slightly smoothed: the highest frequencies hold more noise than texture,
/// and what the sensor has aliased would pull towards whole pixels.
cv::Mat smoothed(const cv::Mat& grey, const cv::Rect& roi) {
    cv::Mat value, smooth;
    grey.rowRange(roi.y, roi.y + roi.height).convertTo(value, CV_32F);
    cv::GaussianBlur(value, smooth, {}, kSmoothingPx, kSmoothingPx, cv::BORDER_REFLECT);
    return smooth;
}

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
    const cv::Mat c = row_spline(left, kSplinePad, for_each);
    for (int y = 0; y < roi.height; ++y) {
        const auto* grey = left.ptr<float>(y) + roi.x;
        const auto* s = c.ptr<float>(y) + roi.x + kSplinePad;
        auto* value = maps.left.ptr<float>(y + maps.pad) + maps.pad;
        auto* slope = maps.gradient.ptr<float>(y + maps.pad) + maps.pad;
        for (int x = 0; x < roi.width; ++x) {
            value[x] = grey[x];
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

/// Scale of the brightness residuals where the match is right: the median over the patches with
/// texture that the right image explains. Wrong matches, of which there may be many, do not count.
float noise_level(const std::vector<PatchFit>& samples) {
    constexpr float kQuantisation = 0.5F;  // levels; two 8-bit images
    constexpr float kTextured = 3.0F;      // levels
    std::vector<float> values;
    for (const PatchFit& fit : samples) {
        if (fit.contrast > kTextured && fit.rms < 0.5F * fit.contrast) values.push_back(fit.rms);
    }
    if (values.empty()) return kQuantisation;
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return std::max(*middle, kQuantisation);
}

bool supported(const PatchFit& fit, float move_px, float sigma_px, const RefineSettings& s) {
    return std::abs(move_px) <= s.max_move_px && sigma_px <= s.max_sigma_px &&
           fit.inliers >= s.min_inliers && fit.lever_px <= s.max_gap_lever_px &&
           fit.rms <= s.max_unexplained * fit.contrast &&
           fit.texture_to_noise >= s.min_texture_to_noise;
}

/// So wrong that further iterations are wasted.
bool hopeless(const PatchFit& fit) {
    return fit.inliers < 0.3F || fit.rms > 0.95F * fit.contrast;
}

/// Pixels whose texture lies around them, and the gaps between such pixels. Beyond a silhouette the
/// texture lies all on one side: the patch reaches over the rim, the surface does not.
cv::Mat enclosed_by_texture(const cv::Mat1f& lever_px, const RefineSettings& settings) {
    cv::Mat centred;
    cv::compare(lever_px, settings.max_lever_px, centred, cv::CMP_LE);
    const int size = 2 * settings.max_gap_px + 1;
    const cv::Mat disc = cv::getStructuringElement(cv::MORPH_ELLIPSE, cv::Size(size, size));
    cv::Mat closed;
    cv::morphologyEx(centred, closed, cv::MORPH_CLOSE, disc);
    return closed;
}

}  // namespace

Refined refine_disparity(const StereoFrame& rectified, const cv::Rect& roi,
                         const cv::Mat& first_guess, const RefineSettings& settings,
                         const ForEach& for_each) {
    PhotometricMaps maps(roi.size(), settings.radius);
    fill_left(smoothed(rectified.left, roi), roi, for_each, maps);
    const cv::Mat right_spline = row_spline(smoothed(rectified.right, roi), kSplinePad, for_each);
    cv::Mat current = first_guess;
    Refined out{cv::Mat(roi.size(), CV_32F, cv::Scalar(kNoDisparity)),
                cv::Mat(roi.size(), CV_32F, cv::Scalar(kNoDisparity))};
    cv::Mat1f lever_px(roi.size(), kNoDisparity);
    PlaneSettings plane_settings;
    plane_settings.radius = settings.radius;
    for (int iteration = 1; iteration <= settings.iterations; ++iteration) {
        const LocalPlanes planes = fit_local_planes(current, plane_settings, for_each);
        fill_residuals(right_spline, roi, planes.value, for_each, maps);
        const float surface_px = iteration == 1 ? 1.5F : 0.75F;
        const float noise = noise_level(sample_patches(maps, planes, surface_px));
        const PatchSettings patch{surface_px, kTukey * noise};
        const bool last = iteration == settings.iterations;
        cv::Mat next(roi.size(), CV_32F, cv::Scalar(kNoDisparity));
        fit_patches(maps, planes, patch, for_each, [&](int y, int x, const PatchFit& fit) {
            if (hopeless(fit)) return;
            const float step = std::clamp(fit.step_px, -0.75F, 0.75F);
            const float d = planes.value.at<float>(y, x) + step;
            next.at<float>(y, x) = d;
            const float sigma =
                std::hypot(fit.sigma_px / std::sqrt(kNoiseKept), settings.systematic_px);
            if (!last || !supported(fit, d - first_guess.at<float>(y, x), sigma, settings)) return;
            out.disparity.at<float>(y, x) = d;
            out.sigma.at<float>(y, x) = sigma;
            lever_px(y, x) = fit.lever_px;
        });
        current = next;
    }
    out.disparity.setTo(cv::Scalar(kNoDisparity), enclosed_by_texture(lever_px, settings) == 0);
    return out;
}

}  // namespace gripscan
