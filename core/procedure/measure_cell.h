// Measures what the cell check assesses: asks the robot, takes one picture, looks at the disk.
#pragma once

#include <filesystem>
#include <optional>
#include <span>

#include "core/base/for_each.h"
#include "core/base/progress.h"
#include "core/camera/stereo_source.h"
#include "core/cloud/cloud.h"
#include "core/geometry/box.h"
#include "core/procedure/cell_facts.h"
#include "core/registration/turn_report.h"

namespace gripscan {

/// A view of the warm-up: cropped to the region, with how far the gripper had turned about the
/// axis, from any start, in the scans' own sense.
struct WarmUpView {
    const Cloud* cloud = nullptr;
    double turned_rad = 0.0;
};

/// References outlive the call.
struct CellUnderTest {
    RobotLink* robot = nullptr;  ///< connected; null: none is read
    StereoSource& source;
    const StereoRig& rig;
    std::optional<Box> region;
    std::filesystem::path session;  ///< its folder; it may not exist yet
    std::optional<Pose> T_robot_camera;
    /// From the warm-up; the direction points into the arm.
    std::optional<AxisEstimate> axis;
    std::span<const WarmUpView> warm_up;
    double settle_s = 0.0;
    std::optional<double> compute_s;  ///< of a step, where one was timed
};

/// Whatever cannot be measured is a fact with its reason. Takes some seconds; the arm is not moved.
/// Errors (device): the camera gives no picture, so that nothing can be said of the cell.
[[nodiscard]] Result<CellFacts> measure_cell(const CellUnderTest& cell, const Progress& progress,
                                             const ForEach& for_each);

}  // namespace gripscan
