// A recording of a few small captures, for tests of the session folder.
#pragma once

#include <opencv2/core.hpp>

#include "core/base/units.h"
#include "core/camera/stereo_source.h"
#include "core/procedure/capture_record.h"

namespace gripscan::test {

inline StereoRig small_rig() {
    StereoRig rig;
    rig.image = {64, 48};
    rig.K_left << 60, 0, 31.5, 0, 60, 23.5, 0, 0, 1;
    rig.K_right = rig.K_left;
    rig.T_right_left.translation().x() = -0.1;
    return rig;
}

inline CaptureRecord small_capture(int index) {
    CaptureRecord capture;
    capture.index = index;
    capture.commanded_rad = index * rad_from_deg(10.0);
    RobotReading reading;
    reading.joints_rad = {0.1, 0.2, 0.3, 0.4, 0.5, capture.commanded_rad - 1.0};
    reading.T_world_tool.translation() = Eigen::Vector3d(0.5, -0.02, 0.48);
    capture.before = reading;
    capture.joint6_after_rad = reading.joints_rad[5] + 1e-4;
    capture.t_s = 0.5 * index;
    return capture;
}

/// Noise, another for every seed.
inline StereoFrame small_frame(int seed) {
    StereoFrame frame{cv::Mat(48, 64, CV_8UC1), cv::Mat(48, 64, CV_8UC1), 0.5 * seed};
    cv::RNG random(static_cast<std::uint64_t>(seed) + 1);
    random.fill(frame.left, cv::RNG::UNIFORM, 0, 255);
    random.fill(frame.right, cv::RNG::UNIFORM, 0, 255);
    return frame;
}

}  // namespace gripscan::test
