// gripscan-alignment/1: where the camera stands relative to the robot, as `calibrate robot` writes
// it and `--alignment` reads it (docs/robot-alignment.md).
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "core/base/result.h"
#include "core/geometry/pose.h"

namespace gripscan {

struct AlignmentFile {
    /// Camera on a stand: where it stands in the robot's frame.
    std::optional<Pose> T_robot_camera;
    /// Camera on the flange: where it is mounted.
    std::optional<Pose> T_flange_camera;
    /// Where the board was: on the flange, or in the robot's frame.
    std::optional<Pose> T_flange_board;
    std::optional<Pose> T_robot_board;
    std::string method;
    int views = 0;
    double spread_mm = 0.0;  ///< rms over the views of where the board is seen
    double spread_deg = 0.0;
    double spread_max_mm = 0.0;
    double spread_max_deg = 0.0;
    double reprojection_px = 0.0;
    double sd_mm = 0.0;
    double sd_deg = 0.0;
};

[[nodiscard]] Status save_alignment(const std::filesystem::path& path, const AlignmentFile& file);

/// Strict: unknown keys, wrong types and what is no rigid motion are errors with file and line. One
/// of T_robot_camera and T_flange_camera must be there; everything else may be missing.
[[nodiscard]] Result<AlignmentFile> load_alignment(const std::filesystem::path& path);

/// T_robot_camera of an alignment file and of nothing else: a cell file that names one must not
/// lead to a cell file again. Errors: as above, a camera on the flange, a cell file.
[[nodiscard]] Result<Pose> load_standing_camera(const std::filesystem::path& path);

/// T_robot_camera of an alignment file or a cell file. Errors: as above, a camera on the flange, a
/// cell file that does not say it.
[[nodiscard]] Result<Pose> load_robot_camera(const std::filesystem::path& path);

}  // namespace gripscan
