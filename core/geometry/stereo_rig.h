// Models of a stereo camera: as calibrated, and as rectified.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "core/base/result.h"
#include "core/geometry/pose.h"

namespace gripscan {

struct ImageSize {
    int width = 0;
    int height = 0;
    friend bool operator==(const ImageSize&, const ImageSize&) = default;
};

/// A calibrated pair as cv::stereoCalibrate gives it. Lengths in m, image quantities in px.
struct StereoRig {
    ImageSize image;
    Eigen::Matrix3d K_left = Eigen::Matrix3d::Identity();
    Eigen::Matrix3d K_right = Eigen::Matrix3d::Identity();
    std::vector<double> D_left;   ///< OpenCV's order: k1 k2 p1 p2 [k3 [k4 k5 k6 …]]
    std::vector<double> D_right;
    Pose T_right_left = Pose::Identity();  ///< R and T of cv::stereoCalibrate

    [[nodiscard]] double baseline_m() const { return T_right_left.translation().norm(); }
    /// R = I, D = 0, T along x, same f and c_y: images can be used untouched.
    [[nodiscard]] bool is_rectified() const;
};

/// What makes no camera: wrong sizes, focal lengths, skew, a baseline of zero or with the wrong
/// sign (the right camera must lie on the right: T_x < 0 and dominating), a right camera that
/// looks elsewhere. The message names the quantity and its value.
[[nodiscard]] Status validate(const StereoRig& rig);

/// The rectified pair in the camera frame of gripscan (left rectified camera, x right, y down,
/// z forward): disparity d = x_left − x_right, Z = f·B/(d + cx_right − cx_left).
struct RectifiedRig {
    ImageSize image;
    double f_px = 0.0;
    double cx_left_px = 0.0;
    double cx_right_px = 0.0;
    double cy_px = 0.0;
    double baseline_m = 0.0;

    [[nodiscard]] double depth_m(double disparity_px) const {
        return f_px * baseline_m / (disparity_px + cx_right_px - cx_left_px);
    }
    [[nodiscard]] double disparity_px(double depth_m) const {
        return f_px * baseline_m / depth_m - cx_right_px + cx_left_px;
    }
    [[nodiscard]] Eigen::Vector3d point_m(double u_px, double v_px, double disparity) const {
        const double z = depth_m(disparity);
        return {(u_px - cx_left_px) * z / f_px, (v_px - cy_px) * z / f_px, z};
    }
    /// Left image coordinates (u, v) of a point in front of the camera.
    [[nodiscard]] Eigen::Vector2d project(const Eigen::Vector3d& p_m) const {
        return {f_px * p_m.x() / p_m.z() + cx_left_px, f_px * p_m.y() / p_m.z() + cy_px};
    }
};

}  // namespace gripscan
