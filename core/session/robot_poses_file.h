// gripscan-robot-poses/1: images of a board with the robot's pose at each, from which
// `calibrate robot` finds where the camera stands (docs/robot-alignment.md).
#pragma once

#include <filesystem>
#include <vector>

#include "core/alignment/board_view.h"
#include "core/alignment/hand_eye.h"

namespace gripscan {

struct RobotPoseRow {
    std::filesystem::path left;   ///< the only image of a single camera
    std::filesystem::path right;  ///< empty: a single camera
    Pose T_robot_flange = Pose::Identity();
};

struct RobotPosesFile {
    Mounting mounting = Mounting::kBoardOnFlange;
    std::filesystem::path rig;  ///< of a stereo camera; empty: `camera`
    MonoCamera camera;
    CalibrationBoard board;
    std::vector<RobotPoseRow> rows;
};

/// Strict: unknown keys, wrong types and rows without image or pose are errors with file and line.
/// Paths are relative to the file.
[[nodiscard]] Result<RobotPosesFile> load_robot_poses(const std::filesystem::path& path);

}  // namespace gripscan
