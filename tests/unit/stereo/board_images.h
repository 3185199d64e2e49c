// Images of a calibration board as a known rig would take them, lens distortion included.
#pragma once

#include <filesystem>
#include <vector>

#include "core/geometry/stereo_rig.h"
#include "core/stereo/calibration_board.h"

namespace gripscan::test {

/// T_left_board of a view; the board's origin is its first corner, z into the board.
using BoardPose = Pose;

struct BoardFiles {
    std::vector<std::filesystem::path> lefts;
    std::vector<std::filesystem::path> rights;
};

/// Renders one pair a pose into `folder` (which is created), blurred and with noise.
[[nodiscard]] BoardFiles write_board_images(const std::filesystem::path& folder,
                                            const StereoRig& rig, const CalibrationBoard& board,
                                            const std::vector<BoardPose>& poses);

/// A pair with distortion and a small toe-in, 640 x 480.
[[nodiscard]] StereoRig distorted_rig();

/// Boards about `distance_m` away, tilted by up to `tilt_rad`, all within both images.
[[nodiscard]] std::vector<BoardPose> board_poses(const CalibrationBoard& board, int count,
                                                 double distance_m, double tilt_rad);

}  // namespace gripscan::test
