// Reads a scene of the Middlebury stereo sets: images, calibration, true disparities.
#pragma once

#include <filesystem>
#include <opencv2/core/mat.hpp>

#include "core/camera/stereo_source.h"
#include "core/geometry/stereo_rig.h"

namespace gripscan::test {

struct MiddleburyScene {
    StereoFrame frame;
    RectifiedRig rig;
    cv::Mat1f truth;  ///< px; +inf where unknown
    int disparities;  ///< to be searched, from 0
};

/// Throws std::runtime_error when a file is missing or malformed.
[[nodiscard]] MiddleburyScene read_middlebury(const std::filesystem::path& folder);

}  // namespace gripscan::test
