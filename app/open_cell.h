// A cell as a run needs it: how to reach its robot and camera, and what is known of the place.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <stop_token>

#include "app/cell_options.h"
#include "core/camera/stereo_source.h"
#include "core/geometry/box.h"
#include "core/geometry/stereo_rig.h"
#include "core/robot/robot_link.h"
#include "core/session/session_spec.h"
#include "core/sim/sim_cell.h"

namespace gripscan::app {

/// The link is not connected yet.
struct Cell {
    std::unique_ptr<SimCell> simulated;  ///< where the cell itself lives in this process
    std::unique_ptr<StereoSource> own_camera;
    StereoSource* camera = nullptr;
    std::unique_ptr<RobotLink> robot;  ///< null: there is none to read
    StereoRig rig;
    std::optional<Box> region;
    std::optional<Eigen::Vector3d> axis_hint;
    std::optional<Pose> T_robot_camera;
    LimitsDeg limits;
    double speed_percent = 10.0;
    double settle_s = 0.3;
};

/// Connects the camera; a stop request ends the waiting for it (cancelled). `tell` hears what is
/// waited for where that takes long; may be empty.
[[nodiscard]] Result<Cell> open_cell(const CellOptions& options, const std::stop_token& stop,
                                     const std::function<void(const std::string&)>& tell);

}  // namespace gripscan::app
