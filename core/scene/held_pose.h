// How the gripper holds an object: one transform from all captures of the object's turn.
#pragma once

#include <optional>
#include <span>

#include "core/geometry/pose.h"

namespace gripscan {

/// A capture in which both were found.
struct HeldView {
    Pose T_camera_gripper = Pose::Identity();  ///< from the gripper template's frame
    Pose T_camera_object = Pose::Identity();   ///< from the object template's frame
};

struct HeldPose {
    /// Points of the object's template, in the frame of the gripper's template, as it is held.
    Pose T_gripper_object = Pose::Identity();
    double sd_rad = 0.0;  ///< of the mean, from the scatter of the captures
    double sd_m = 0.0;    ///< the same, of the object's middle
    std::size_t captures = 0;
};

/// The mean over the captures, of the rotation and of where `centre_m` (object's frame) stands.
/// Nothing without captures.
[[nodiscard]] std::optional<HeldPose> held_pose(std::span<const HeldView> views,
                                                const Eigen::Vector3d& centre_m);

}  // namespace gripscan
