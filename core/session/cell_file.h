// The cell file (gripscan-cell/1): which robot, which camera, where things are.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "core/base/result.h"
#include "core/geometry/pose.h"
#include "core/session/session_spec.h"

namespace gripscan {

struct CellRobot {
    std::string dialect;
    std::string host;
    std::optional<int> port;
    std::optional<int> monitor_port;
    std::optional<double> speed_percent;
    std::optional<double> settle_ms;
};

struct CellFile {
    std::optional<CellRobot> robot;
    std::string camera_driver;  ///< empty: none named
    std::string rig;            ///< path, relative to the cell file
    std::optional<Box> region;
    std::optional<Eigen::Vector3d> axis_hint;
    std::optional<Pose> T_robot_camera;
    LimitsDeg limits;
    std::string template_library;
};

/// Strict: unknown keys and wrong types are errors with file and line.
[[nodiscard]] Result<CellFile> load_cell_file(const std::filesystem::path& path);

}  // namespace gripscan
