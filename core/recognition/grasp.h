// The grasp learned at registration, repeated where the object stands now.
#pragma once

#include <span>

#include "core/geometry/pose.h"
#include "core/robot/inverse_kinematics.h"

namespace gripscan {

/// What the grasp is made of.
struct Grasp {
    Pose T_gripper_object = Pose::Identity();  ///< as the object was held, template frames
    Pose T_tool_gripper = Pose::Identity();    ///< the gripper template's frame in tool0
};

struct GraspPose {
    Pose T_robot_gripper = Pose::Identity();  ///< the gripper template's frame
    Pose T_robot_tool = Pose::Identity();     ///< tool0 in FANUC WORLD
    Reachability reach;
};

/// The pose that lets the gripper hold the object as before, and whether the arm gets there from
/// near_rad.
[[nodiscard]] GraspPose grasp_pose(const Pose& T_robot_object, const Grasp& grasp,
                                   const JointAngles& near_rad);

/// Of the poses in which a symmetric object looks the same, the one that the arm reaches with the
/// smallest motion; the given one where it reaches none.
[[nodiscard]] GraspPose best_grasp(std::span<const Pose> T_robot_object, const Grasp& grasp,
                                   const JointAngles& near_rad);

/// Where the gripper template's frame lies in tool0: from the joints at the capture whose camera
/// frame it is.
[[nodiscard]] Pose T_tool_template(const Pose& T_robot_camera, const JointAngles& joints_rad);

/// FANUC's six numbers: X Y Z in mm, W P R in deg.
struct FanucPose {
    double x_mm = 0.0, y_mm = 0.0, z_mm = 0.0;
    double w_deg = 0.0, p_deg = 0.0, r_deg = 0.0;
};
[[nodiscard]] FanucPose fanuc_pose(const Pose& T);

}  // namespace gripscan
