#include "core/sim/glare.h"

#include <algorithm>
#include <cmath>

namespace gripscan::sim {

void add_glare(cv::Mat& brightness, cv::Point2d centre_px, double radius_px) {
    constexpr double kWhite = 255.0;
    constexpr double kCore = 4.0 * kWhite;  // the sensor clips it
    // A Gaussian that falls to white at the radius.
    const double sigma2 = radius_px * radius_px / (2.0 * std::log(kCore / kWhite));
    const int reach = static_cast<int>(std::ceil(4.0 * std::sqrt(sigma2)));
    const cv::Point centre(static_cast<int>(std::lround(centre_px.x)),
                           static_cast<int>(std::lround(centre_px.y)));
    const cv::Rect spot = cv::Rect(centre.x - reach, centre.y - reach, 2 * reach + 1,
                                   2 * reach + 1) &
                          cv::Rect({}, brightness.size());
    for (int row = spot.y; row < spot.y + spot.height; ++row) {
        for (int column = spot.x; column < spot.x + spot.width; ++column) {
            const double x = column - centre_px.x;
            const double y = row - centre_px.y;
            brightness.at<float>(row, column) +=
                static_cast<float>(kCore * std::exp(-(x * x + y * y) / (2.0 * sigma2)));
        }
    }
}

}  // namespace gripscan::sim
