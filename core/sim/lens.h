// A camera with a real lens, as the renderer sees it: where in the world each place of the image
// looks, by OpenCV's model (pinhole with k1 k2 p1 p2 k3).
#pragma once

#include <Eigen/Core>
#include <vector>

#include "core/geometry/stereo_rig.h"

namespace gripscan::sim {

class Lens {
  public:
    Lens(const Eigen::Matrix3d& K, const std::vector<double>& D, ImageSize image);

    [[nodiscard]] ImageSize image() const { return image_; }

    /// (x/z, y/z) seen at the place (u, v) px; pixel centres are whole numbers. Places up to half
    /// a pixel outside the outer centres are inside.
    [[nodiscard]] Eigen::Vector2f direction_at(float u_px, float v_px) const;

    /// The image of a point of the camera's own frame, z > 0.
    [[nodiscard]] Eigen::Vector2d project(const Eigen::Vector3d& p_m) const;

  private:
    [[nodiscard]] Eigen::Vector2d distorted(const Eigen::Vector2d& x) const;
    [[nodiscard]] Eigen::Vector2d undistorted(const Eigen::Vector2d& x) const;

    Eigen::Matrix3d K_;
    std::array<double, 5> D_{};
    ImageSize image_;
    std::vector<Eigen::Vector2f> grid_;  ///< direction at the corners of the pixels
};

}  // namespace gripscan::sim
