#include "app/workstation/picture_facts.h"

#include <limits>
#include <opencv2/core.hpp>

#include "core/stereo/search_area.h"

namespace gripscan::app {

StereoHealth exposure_of(const cv::Mat& image, const RectifiedRig& rig,
                         const std::optional<Box>& region) {
    constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();
    StereoHealth health;
    health.fill = health.row_error_px = health.sharpness = health.contrast = kUnknown;
    health.texture = kUnknown;
    const auto area = search_area(rig, region, {});
    const cv::Rect whole(0, 0, image.cols, image.rows);
    const cv::Mat seen = image(area ? (area->roi & whole) : whole);
    if (seen.empty()) return health;
    const auto count = static_cast<double>(seen.total());
    health.mean_intensity = cv::mean(seen)[0];
    health.saturated = (cv::countNonZero(seen == 255) + cv::countNonZero(seen == 0)) / count;
    health.glare = cv::countNonZero(seen >= 250) / count;
    return health;
}

cv::Mat disparity_of(const Cloud& cloud, const RectifiedRig& rig) {
    if (cloud.grid_width != rig.image.width || cloud.grid_height != rig.image.height ||
        !cloud.organised()) {
        return {};
    }
    cv::Mat disparity(rig.image.height, rig.image.width, CV_32F,
                      cv::Scalar(std::numeric_limits<float>::infinity()));
    for (std::size_t i = 0; i < cloud.size(); ++i) {
        const int cell = cloud.cell[i];
        const double z_m = static_cast<double>(cloud.points[i].z());
        disparity.at<float>(cell / cloud.grid_width, cell % cloud.grid_width) =
            static_cast<float>(rig.f_px * rig.baseline_m / z_m + rig.cx_left_px - rig.cx_right_px);
    }
    return disparity;
}

}  // namespace gripscan::app
