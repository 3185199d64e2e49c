// The cell file (gripscan-cell/1): which robot, which camera, where things are.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "core/base/result.h"
#include "core/geometry/pose.h"
#include "core/geometry/stereo_rig.h"
#include "core/session/session_spec.h"

namespace gripscan {

/// Keys that are absent have these values; dialect and host must be there.
struct CellRobot {
    std::string dialect;  ///< such as "gsp1"
    std::string host;
    int port = 18740;          ///< of motions
    int monitor_port = 18741;  ///< absent: port + 1
    double speed_percent = 10.0;
    double settle_s = 0.3;  ///< from the end of a motion to the exposure

    friend bool operator==(const CellRobot&, const CellRobot&) = default;
};

/// `camera: {driver: frames, …}`: a server of stereo pairs, as `gripscan simcell` is one.
struct FrameServer {
    std::string host;
    int port = 18742;

    friend bool operator==(const FrameServer&, const FrameServer&) = default;
};

struct CellFile {
    std::optional<CellRobot> robot;
    std::optional<FrameServer> camera;
    std::filesystem::path rig;  ///< absolute or relative to the working folder; empty: not given
    std::optional<Box> region;
    std::optional<Eigen::Vector3d> axis_hint;
    std::optional<Pose> T_robot_camera;
    LimitsDeg limits;
    std::filesystem::path template_library;  ///< as `rig`
};

/// Strict: unknown keys, drivers and wrong types are errors with file and line. Paths in the file
/// are relative to it.
[[nodiscard]] Result<CellFile> load_cell_file(const std::filesystem::path& path);

/// Every value is written; paths inside the file's folder as they are from there, so that the
/// folder can be moved, all others absolute.
[[nodiscard]] Status save_cell_file(const std::filesystem::path& path, const CellFile& cell);

}  // namespace gripscan
