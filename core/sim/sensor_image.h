// From brightness to what the sensor delivers: blur of the lens, vignetting, noise, 8 bit.
#pragma once

#include <cstdint>
#include <opencv2/core/mat.hpp>

#include "core/base/for_each.h"

namespace gripscan::sim {

struct SensorSettings {
    double blur_px = 0.6;       ///< Gaussian sigma
    double noise_levels = 2.0;  ///< standard deviation, of 255
    double vignetting = 0.22;   ///< share of the light that is lost in the corners
};

/// CV_32F levels to CV_8U. The noise is a function of its seed alone.
[[nodiscard]] cv::Mat sensor_image(const cv::Mat& brightness, const SensorSettings& settings,
                                   std::uint64_t noise_seed, const ForEach& for_each);

}  // namespace gripscan::sim
