// Rectification: from the sensors' images to the camera frame of gripscan.
#pragma once

#include <memory>

#include "core/camera/stereo_source.h"
#include "core/geometry/stereo_rig.h"

namespace gripscan {

/// R1 of cv::stereoRectify(…, CALIB_ZERO_DISPARITY, alpha = −1) is the camera frame. A rig that is
/// rectified already leaves the images untouched, on the input grid.
class Rectifier {
  public:
    [[nodiscard]] static Result<Rectifier> create(const StereoRig& rig);
    Rectifier(Rectifier&&) noexcept;
    Rectifier& operator=(Rectifier&&) noexcept;
    ~Rectifier();

    [[nodiscard]] const RectifiedRig& rig() const;
    /// R1: directions of the left camera as calibrated, turned into the camera frame.
    [[nodiscard]] const Eigen::Matrix3d& R_rectified_left() const;
    /// Grey 8-bit images of the rig's size, rectified. A wrong size is an error.
    [[nodiscard]] Result<StereoFrame> rectify(const StereoFrame& frame) const;

  private:
    struct Maps;
    explicit Rectifier(std::unique_ptr<Maps> maps);
    std::unique_ptr<Maps> maps_;
};

}  // namespace gripscan
