// Where stereo images come from: a camera, a recording, the simulated cell.
#pragma once

#include <cstdint>
#include <opencv2/core/mat.hpp>
#include <optional>

#include "core/base/result.h"
#include "core/geometry/stereo_rig.h"

namespace gripscan {

/// One exposure of both cameras: 8-bit grey, same size, as the sensors deliver it (not rectified).
struct StereoFrame {
    cv::Mat left;
    cv::Mat right;
    double t_s = 0.0;  ///< time of the exposure since the source was opened
};

/// What the frame is for. A simulated source makes its noise from it, so that asking again for the
/// same capture and attempt gives the same images.
struct FrameRequest {
    int capture = 0;
    int attempt = 1;
};

class StereoSource {
  public:
    virtual ~StereoSource() = default;
    [[nodiscard]] virtual Result<StereoFrame> grab(const FrameRequest& request) = 0;
};

}  // namespace gripscan
