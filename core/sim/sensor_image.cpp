#include "core/sim/sensor_image.h"

#include <cmath>
#include <opencv2/imgproc.hpp>

#include "core/base/seeded_random.h"

namespace gripscan::sim {

cv::Mat sensor_image(const cv::Mat& brightness, const SensorSettings& settings,
                     std::uint64_t noise_seed, const ForEach& for_each) {
    cv::Mat blurred;  // its own memory: the brightness is used again for the next exposure
    if (settings.blur_px > 0.0) {
        cv::GaussianBlur(brightness, blurred, {}, settings.blur_px, settings.blur_px,
                         cv::BORDER_REPLICATE);
    } else {
        blurred = brightness;
    }
    cv::Mat image(brightness.size(), CV_8U);
    const double centre_x = (image.cols - 1) / 2.0;
    const double centre_y = (image.rows - 1) / 2.0;
    const double corner2 = centre_x * centre_x + centre_y * centre_y;
    for_each(static_cast<std::size_t>(image.rows), [&](std::size_t index) {
        const int row = static_cast<int>(index);
        SeededRandom random(SeededRandom(noise_seed + index).next());
        const auto* in = blurred.ptr<float>(row);
        auto* out = image.ptr<std::uint8_t>(row);
        const double y = row - centre_y;
        for (int column = 0; column < image.cols; ++column) {
            const double x = column - centre_x;
            const double fall = 1.0 - settings.vignetting * (x * x + y * y) / corner2;
            const double level = in[column] * fall + settings.noise_levels * random.normal();
            out[column] = cv::saturate_cast<std::uint8_t>(level);
        }
    });
    return image;
}

}  // namespace gripscan::sim
