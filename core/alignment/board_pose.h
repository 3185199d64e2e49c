// The pose of a board from its corners in one or two ideal cameras.
#pragma once

#include "core/alignment/board_view.h"

namespace gripscan {

/// Starts from a plane-to-image homography, and refines on the reprojection in all images. Sets
/// pose and rms_px; false if there is no pose in front of the camera.
[[nodiscard]] bool estimate_board_pose(const RectifiedRig& camera, BoardObservation& observation);

/// Residuals (px) of all corners, left then right, at a point-wise pose, and their slopes by a
/// small motion [ω; v] of the board in the camera frame about `centre`. Used for any chain of
/// poses.
struct CornerResidual {
    Eigen::Vector2d px;
    Eigen::Matrix<double, 2, 3> by_point;  ///< slope by the point in the camera frame
    std::size_t corner;
};
[[nodiscard]] std::vector<CornerResidual> corner_residuals(const RectifiedRig& camera,
                                                           const BoardObservation& observation,
                                                           const Pose& T_camera_board);

}  // namespace gripscan
