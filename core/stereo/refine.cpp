#include "core/stereo/refine.h"

#include <algorithm>
#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>

#include "core/stereo/local_plane.h"
#include "core/stereo/match.h"
#include "core/stereo/photometric_fit.h"

namespace gripscan {
namespace {

/// Tukey's limit for 95 % efficiency under normal noise.
constexpr float kTukey = 4.7F;

/// The camera pair as the right matches show it.
struct Exposure {
    float noise_levels;  ///< scale of the residuals
    float gain;          ///< right over left, minus 1
};

float median(std::vector<float>& values) {
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

/// Medians over the patches with texture that the right image explains: wrong matches, of which
/// there may be many, do not count.
Exposure exposure(const std::vector<PatchFit>& samples) {
    constexpr float kQuantisation = 0.5F;  // levels; two 8-bit images
    constexpr float kTextured = 3.0F;      // levels
    std::vector<float> rms;
    std::vector<float> gain;
    for (const PatchFit& fit : samples) {
        if (fit.contrast <= kTextured || fit.rms >= 0.5F * fit.contrast) continue;
        rms.push_back(fit.rms);
        gain.push_back(fit.gain);
    }
    if (rms.empty()) return {kQuantisation, 0.0F};
    return {std::max(median(rms), kQuantisation), std::clamp(median(gain), -0.5F, 1.0F)};
}

/// Residuals at the planes' disparities, without the cameras' difference in exposure. Returns the
/// scale of the residuals where the match is right.
float compare_brightness(Photometry& photometry, const LocalPlanes& planes, float surface_px,
                         const ForEach& for_each) {
    photometry.sample_right(planes.value, for_each);
    Exposure found = exposure(sample_patches(photometry.maps(), planes, surface_px));
    constexpr float kNoticeableGain = 0.01F;
    if (std::abs(found.gain) > kNoticeableGain) {
        photometry.take_out_gain(found.gain);
        photometry.sample_right(planes.value, for_each);
    }
    photometry.take_out_offset(kTukey * found.noise_levels);
    return found.noise_levels;
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
    Photometry photometry(rectified, roi, settings.radius, for_each);
    cv::Mat current = first_guess;
    Refined out{cv::Mat(roi.size(), CV_32F, cv::Scalar(kNoDisparity)),
                cv::Mat(roi.size(), CV_32F, cv::Scalar(kNoDisparity))};
    cv::Mat1f lever_px(roi.size(), kNoDisparity);
    PlaneSettings plane_settings;
    plane_settings.radius = settings.radius;
    plane_settings.look_beside = settings.look_beside;
    for (int iteration = 1; iteration <= settings.iterations; ++iteration) {
        const LocalPlanes planes = fit_local_planes(current, plane_settings, for_each);
        const float surface_px = iteration == 1 ? 1.5F : 0.75F;
        const float noise = compare_brightness(photometry, planes, surface_px, for_each);
        const PatchSettings patch{surface_px, kTukey * noise};
        const bool last = iteration == settings.iterations;
        cv::Mat next(roi.size(), CV_32F, cv::Scalar(kNoDisparity));
        fit_patches(
            photometry.maps(), planes, patch, for_each, [&](int y, int x, const PatchFit& fit) {
                if (hopeless(fit)) return;
                const float step = std::clamp(fit.step_px, -0.75F, 0.75F);
                const float d = planes.value.at<float>(y, x) + step;
                next.at<float>(y, x) = d;
                const float sigma =
                    std::hypot(fit.sigma_px / std::sqrt(kNoiseKept), settings.systematic_px);
                if (!last || !supported(fit, d - first_guess.at<float>(y, x), sigma, settings))
                    return;
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
