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
/// same capture, attempt and exposure gives the same images.
struct FrameRequest {
    int capture = 0;   ///< index of the capture; negative: a picture that is not kept
    int attempt = 1;
    int exposure = 0;  ///< 0: the one that is kept; others are only compared with it
};

class StereoSource {
  public:
    virtual ~StereoSource() = default;
    [[nodiscard]] virtual Result<StereoFrame> grab(const FrameRequest& request) = 0;
};

}  // namespace gripscan
