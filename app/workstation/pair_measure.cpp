#include "app/workstation/pair_measure.h"

#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>

#include "app/workstation/picture_facts.h"
#include "core/base/for_each.h"
#include "core/stereo/row_error.h"
#include "core/stereo/search_area.h"
#include "core/stereo/stereo_cloud.h"

namespace gripscan::app {
namespace {

constexpr int kShrink = 2;

/// Of images whose pixels are the means of kShrink × kShrink.
RectifiedRig shrunk(const RectifiedRig& rig) {
    const auto column = [](double at_px) { return (at_px + 0.5) / kShrink - 0.5; };
    RectifiedRig small = rig;
    small.image = {rig.image.width / kShrink, rig.image.height / kShrink};
    small.f_px = rig.f_px / kShrink;
    small.cx_left_px = column(rig.cx_left_px);
    small.cx_right_px = column(rig.cx_right_px);
    small.cy_px = column(rig.cy_px);
    return small;
}

cv::Mat shrunk(const cv::Mat& image, const ImageSize& size) {
    cv::Mat small;
    const cv::Rect whole_blocks(0, 0, kShrink * size.width, kShrink * size.height);
    cv::resize(image(whole_blocks), small, {size.width, size.height}, 0.0, 0.0, cv::INTER_AREA);
    return small;
}

/// Disparities of the small image at the large one's pixels and in its unit.
cv::Mat grown(const cv::Mat& small, const cv::Size& size) {
    if (small.empty()) return {};
    cv::Mat large;
    cv::resize(small, large, size, 0.0, 0.0, cv::INTER_NEAREST);
    return large * static_cast<double>(kShrink);
}

void measure_rows(const ui::StereoPicture& pair, const RectifiedRig& rig,
                  const std::optional<Box>& region, const std::stop_token& stop,
                  ui::PairFacts& facts) {
    const auto area = search_area(rig, region, {});
    if (!area) {
        facts.why_no_row_error = area.error().message;
        return;
    }
    const auto rows = measure_row_error({pair.left, pair.right, pair.t_s}, *area, {}, stop);
    if (!rows) {
        facts.why_no_row_error = rows.error().message;
        return;
    }
    facts.row_error_px = rows->median_px;
    facts.row_error_sd_px = rows->sd_px;
}

}  // namespace

Result<MeasuredPair> measure_pair(const ui::StereoPicture& rectified, const RectifiedRig& rig,
                                  const std::optional<Box>& region, const std::stop_token& stop) {
    MeasuredPair measured;
    measure_rows(rectified, rig, region, stop, measured.facts);
    if (stop.stop_requested()) return cancelled_error();
    const RectifiedRig small = shrunk(rig);
    const auto cloud = stereo_cloud(
        {shrunk(rectified.left, small.image), shrunk(rectified.right, small.image), rectified.t_s},
        small, region, {}, {stop, {}}, for_each_in_order);
    if (stop.stop_requested()) return cancelled_error();
    auto picture = std::make_shared<ui::StereoPicture>(rectified);
    if (cloud) {
        measured.facts.fill = cloud->health.fill;
        picture->disparity = grown(disparity_of(cloud->cloud, small), rectified.left.size());
    } else {
        measured.facts.why_no_fill = cloud.error().message;
    }
    measured.picture = std::move(picture);
    return measured;
}

}  // namespace gripscan::app
