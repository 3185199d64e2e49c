#include "core/stereo/stereo_cloud.h"

#include <array>
#include <cmath>
#include <opencv2/core.hpp>

#include "core/stereo/fill.h"
#include "core/stereo/health.h"
#include "core/stereo/match.h"
#include "core/stereo/refine.h"
#include "core/stereo/reject.h"
#include "core/stereo/search_area.h"
#include "core/stereo/triangulate.h"

namespace gripscan {
namespace {

/// Without refinement SGBM's error counts: mostly pixel locking.
constexpr float kUnrefinedSigmaPx = 0.2F;
/// Radius of the narrow patches, and how well the wide ones must agree with them.
constexpr int kNarrowPatchPx = 4;
constexpr float kAgreementSigmas = 1.5F;
/// Smaller connected pieces of a first guess are chance matches.
constexpr int kMinIslandPx = 100;
constexpr float kIslandStepPx = 1.0F;

Status check(const StereoFrame& frame, const RectifiedRig& rig) {
    const std::array<std::pair<const char*, const cv::Mat*>, 2> images{
        {{"left", &frame.left}, {"right", &frame.right}}};
    for (const auto& [which, image] : images) {
        if (image->type() != CV_8UC1) {
            return input_error("the {} image must be 8-bit grey", which);
        }
        if (image->cols != rig.image.width || image->rows != rig.image.height) {
            return input_error("the {} image is {} x {} px, the rig says {} x {}", which,
                               image->cols, image->rows, rig.image.width, rig.image.height);
        }
    }
    return {};
}

/// Wide patches know a surface best; narrow ones follow it into corners and up to its rim. The wide
/// result stands where the narrow one agrees, else the narrow one.
Refined refine_at_two_scales(const StereoFrame& rectified, const cv::Rect& roi,
                             const cv::Mat& first_guess, const ForEach& for_each) {
    RefineSettings narrow;
    narrow.radius = kNarrowPatchPx;
    narrow.look_beside = true;
    Refined result = refine_disparity(rectified, roi, first_guess, narrow, for_each);
    const Refined wide = refine_disparity(rectified, roi, first_guess, {}, for_each);
    for (int y = 0; y < roi.height; ++y) {
        for (int x = 0; x < roi.width; ++x) {
            const float w = wide.disparity.at<float>(y, x);
            float& n = result.disparity.at<float>(y, x);
            float& sigma = result.sigma.at<float>(y, x);
            if (!std::isfinite(w) || !(std::abs(w - n) < kAgreementSigmas * sigma)) continue;
            n = w;
            sigma = wide.sigma.at<float>(y, x);
        }
    }
    return result;
}

/// The full image with the disparities of the roi; dense where there is no region.
cv::Mat full_disparity(const cv::Mat& measured, const cv::Mat& first_guess, const cv::Rect& roi,
                       cv::Size size, bool dense) {
    cv::Mat full(size, CV_32F, cv::Scalar(kNoDisparity));
    measured.copyTo(full(roi));
    if (!dense) return full;
    cv::Mat inside = full(roi);
    for (int y = 0; y < roi.height; ++y) {
        for (int x = 0; x < roi.width; ++x) {
            float& d = inside.at<float>(y, x);
            if (!std::isfinite(d)) d = first_guess.at<float>(y, x);
        }
    }
    fill_holes(full);
    return full;
}

}  // namespace

Result<StereoCloud> stereo_cloud(const StereoFrame& rectified, const RectifiedRig& rig,
                                 const std::optional<Box>& region, const StereoSettings& settings,
                                 const Progress& progress, const ForEach& for_each) {
    if (const Status s = check(rectified, rig); !s) return forward_error(s.error());
    const Result<SearchArea> area = search_area(rig, region, settings);
    if (!area) return forward_error(area.error());
    const cv::Rect& roi = area->roi;
    cv::Mat first_guess = match(rectified, *area);
    reject_islands(first_guess, kMinIslandPx, kIslandStepPx);
    if (progress.cancelled()) return cancelled_error();
    Refined refined{first_guess.clone(),
                    cv::Mat(roi.size(), CV_32F, cv::Scalar(kUnrefinedSigmaPx))};
    if (settings.refine) {
        refined = refine_at_two_scales(rectified, roi, first_guess, for_each);
    }
    if (progress.cancelled()) return cancelled_error();
    StereoCloud result;
    result.health = stereo_health(rectified, roi, refined.disparity);
    cv::Mat kept = refined.disparity.clone();
    if (settings.reject_silhouettes) reject_silhouettes(kept, RejectSettings{});
    const std::optional<Box> keep = settings.crop_to_region ? region : std::nullopt;
    result.cloud = triangulate(kept, refined.sigma, roi, rectified.left, rig, keep, for_each);
    result.disparity = full_disparity(region ? kept : refined.disparity, first_guess, roi,
                                      rectified.left.size(), !region);
    return result;
}

}  // namespace gripscan
