// A calibration board as a camera or a stereo camera sees it: corners in ideal pixels, and its
// pose.
#pragma once

#include <optional>
#include <vector>

#include "core/camera/stereo_source.h"
#include "core/stereo/calibration_board.h"

namespace gripscan {

/// A single camera as calibrated.
struct MonoCamera {
    double fx_px = 0.0;
    double fy_px = 0.0;
    double cx_px = 0.0;
    double cy_px = 0.0;
    std::vector<double> distortion;  ///< k1 k2 p1 p2 [k3]
};

/// Corners in the pixels of a camera without distortion. The camera frame is the one of gripscan:
/// left rectified, or that of the single camera.
struct BoardObservation {
    std::vector<Eigen::Vector3d> board_m;
    std::vector<Eigen::Vector2d> left_px;
    std::vector<Eigen::Vector2d> right_px;  ///< empty: a single camera
    Pose T_camera_board = Pose::Identity();
    double rms_px = 0.0;  ///< reprojection at that pose
};

/// Sees boards: undistorts, keeps the numbering the same in every view, estimates the pose.
class BoardEye {
  public:
    /// Errors: a board that makes none, or a chessboard that looks the same after half a turn (even
    /// sum of inner corners): as the robot turns it, its corners could not be told apart.
    [[nodiscard]] static Result<BoardEye> create(const StereoRig& rig,
                                                 const CalibrationBoard& board);
    [[nodiscard]] static Result<BoardEye> create(const MonoCamera& camera,
                                                 const CalibrationBoard& board);

    /// Nothing if there is no board in it, or too little of it. `right` is empty for a single
    /// camera.
    [[nodiscard]] std::optional<BoardObservation> look(const cv::Mat& left,
                                                       const cv::Mat& right) const;

    /// The camera of the observations' pixels; a single one has no baseline.
    [[nodiscard]] const RectifiedRig& camera() const { return camera_; }
    [[nodiscard]] bool stereo() const { return rig_.has_value(); }

  private:
    BoardEye(CalibrationBoard board) : board_(std::move(board)) {}

    CalibrationBoard board_;
    std::optional<StereoRig> rig_;
    MonoCamera mono_;
    RectifiedRig camera_;
    cv::Mat R_left_;  ///< rectification
    cv::Mat R_right_;
};

/// Pixels of the left (and right) camera in which a point of the camera frame is seen.
[[nodiscard]] inline Eigen::Vector2d left_pixel(const RectifiedRig& camera,
                                                const Eigen::Vector3d& p_m) {
    return camera.project(p_m);
}
[[nodiscard]] inline Eigen::Vector2d right_pixel(const RectifiedRig& camera,
                                                 const Eigen::Vector3d& p_m) {
    return {camera.f_px * (p_m.x() - camera.baseline_m) / p_m.z() + camera.cx_right_px,
            camera.f_px * p_m.y() / p_m.z() + camera.cy_px};
}

}  // namespace gripscan
