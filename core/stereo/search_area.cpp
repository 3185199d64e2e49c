#include "core/stereo/search_area.h"

#include <algorithm>
#include <cmath>

namespace gripscan {
namespace {

/// Patches at the border of the region need their surroundings.
constexpr int kMarginPx = 12;
/// Surfaces just outside are matched at their own depth rather than forced to a wrong one inside.
constexpr int kMarginDisparityPx = 3;

struct DisparityRange {
    double low = 0.0;
    double high = 0.0;
};

int round_up_to_16(double count) {
    return 16 * static_cast<int>(std::ceil(count / 16.0));
}

/// The region in front of the camera, no nearer than the largest disparity the image can hold.
Result<Box> visible_part(const Box& region, const RectifiedRig& rig) {
    if (!region.valid()) {
        return input_error(
            "the region is empty: min ({}, {}, {}) m must be below max ({}, {}, {}) "
            "m in every coordinate",
            region.min_m.x(), region.min_m.y(), region.min_m.z(), region.max_m.x(),
            region.max_m.y(), region.max_m.z());
    }
    Box part = region;
    part.min_m.z() = std::max(part.min_m.z(), rig.depth_m(rig.image.width - 1.0));
    if (!part.valid()) {
        return input_error(
            "the region ends at z = {} m: behind the camera or nearer than both "
            "cameras see",
            region.max_m.z());
    }
    return part;
}

cv::Rect projection(const Box& box, const RectifiedRig& rig) {
    Eigen::Array2d low = Eigen::Array2d::Constant(1e9);
    Eigen::Array2d high = -low;
    for (const Eigen::Vector3d& corner : box.corners()) {
        const Eigen::Array2d p = rig.project(corner).array();
        low = low.min(p);
        high = high.max(p);
    }
    const Eigen::Array2d limit(rig.image.width, rig.image.height);
    const Eigen::Array2i from = (low.floor() - kMarginPx).max(0.0).min(limit).cast<int>();
    const Eigen::Array2i to = (high.ceil() + kMarginPx + 1).max(0.0).min(limit).cast<int>();
    return {cv::Point(from.x(), from.y()), cv::Point(to.x(), to.y())};
}

}  // namespace

Result<SearchArea> search_area(const RectifiedRig& rig, const std::optional<Box>& region,
                               const StereoSettings& settings) {
    SearchArea area;
    area.roi = cv::Rect(0, 0, rig.image.width, rig.image.height);
    DisparityRange range{0.0, rig.image.width / 4.0};
    if (region) {
        const Result<Box> part = visible_part(*region, rig);
        if (!part) return forward_error(part.error());
        area.roi = projection(*part, rig);
        if (area.roi.width <= 2 * kMarginPx || area.roi.height <= 2 * kMarginPx) {
            return input_error(
                "the region lies outside the left image: x {} … {}, y {} … {}, z {} "
                "… {} m",
                region->min_m.x(), region->max_m.x(), region->min_m.y(), region->max_m.y(),
                region->min_m.z(), region->max_m.z());
        }
        range = {rig.disparity_px(part->max_m.z()) - kMarginDisparityPx,
                 rig.disparity_px(part->min_m.z()) + kMarginDisparityPx};
    }
    if (settings.min_disparity) range.low = *settings.min_disparity;
    area.min_disparity = static_cast<int>(std::floor(range.low));
    area.num_disparities = settings.num_disparities
                               ? round_up_to_16(*settings.num_disparities)
                               : round_up_to_16(range.high - area.min_disparity + 1.0);
    if (area.num_disparities < 16 || area.num_disparities > rig.image.width ||
        std::abs(area.min_disparity) >= rig.image.width) {
        const bool given = settings.min_disparity || settings.num_disparities;
        const std::string cause =
            region && !given ? fmt::format("the region, z {} … {} m, comes too near the cameras: ",
                                           region->min_m.z(), region->max_m.z())
                             : "";
        return input_error("{}disparities {} … {} px make no sense for images {} px wide", cause,
                           area.min_disparity, area.min_disparity + area.num_disparities - 1,
                           rig.image.width);
    }
    return area;
}

}  // namespace gripscan
