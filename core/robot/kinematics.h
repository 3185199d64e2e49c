// Where the links of a FANUC LR Mate 200iC/5L are, from its joint angles. Joints are FANUC's (J3 is
// measured against the horizontal), poses are in FANUC WORLD (on axis 1, at the height of axis 2).
// Lengths in m, angles in rad.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <optional>

#include "core/base/result.h"
#include "core/geometry/axis.h"
#include "core/geometry/pose.h"
#include "core/robot/robot_link.h"

namespace gripscan {

struct JointRange {
    double min_rad = 0.0;
    double max_rad = 0.0;
};

/// What each joint's motor may do; the third entry is the elbow's own angle, J2 + J3.
[[nodiscard]] const std::array<JointRange, 6>& joint_ranges();

/// The message names the joint, its angle and its range.
[[nodiscard]] Status check_joint_ranges(const JointAngles& joints_rad);

/// T_world_link of the base (0) and of links 1 … 6. At all joints zero the frames are parallel to
/// WORLD: forearm along x, upper arm along z. Link 6 is the flange, its face looks along its x.
[[nodiscard]] std::array<Pose, 7> link_poses(const JointAngles& joints_rad);

/// T_world_tool of tool0: on the flange's face, z out of it.
[[nodiscard]] Pose tool_pose(const JointAngles& joints_rad);

/// The line in WORLD about which joint `number` (1 … 6) turns; its positive turn by the right hand.
[[nodiscard]] Axis joint_axis(const JointAngles& joints_rad, std::size_t number);

}  // namespace gripscan
