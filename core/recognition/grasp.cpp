#include "core/recognition/grasp.h"

#include <algorithm>
#include <cmath>

#include "core/base/units.h"

namespace gripscan {
namespace {

double largest_motion(const JointAngles& a, const JointAngles& b) {
    double largest = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i) largest = std::max(largest, std::abs(a[i] - b[i]));
    return largest;
}

}  // namespace

GraspPose grasp_pose(const Pose& T_robot_object, const Grasp& grasp, const JointAngles& near_rad) {
    GraspPose result;
    result.T_robot_gripper = T_robot_object * grasp.T_gripper_object.inverse();
    result.T_robot_tool = result.T_robot_gripper * grasp.T_tool_gripper.inverse();
    result.reach = reachability(result.T_robot_tool, near_rad);
    return result;
}

GraspPose best_grasp(std::span<const Pose> T_robot_object, const Grasp& grasp,
                     const JointAngles& near_rad) {
    GraspPose best = grasp_pose(T_robot_object.front(), grasp, near_rad);
    for (const Pose& T : T_robot_object.subspan(1)) {
        GraspPose other = grasp_pose(T, grasp, near_rad);
        if (!other.reach.reachable) continue;
        if (!best.reach.reachable || largest_motion(other.reach.joints_rad, near_rad) <
                                         largest_motion(best.reach.joints_rad, near_rad)) {
            best = std::move(other);
        }
    }
    return best;
}

Pose T_tool_template(const Pose& T_robot_camera, const JointAngles& joints_rad) {
    return tool_pose(joints_rad).inverse() * T_robot_camera;
}

FanucPose fanuc_pose(const Pose& T) {
    const EulerAngles a = euler_from_rotation(T.linear());
    const Eigen::Vector3d t = kMmPerM * T.translation();
    return {t.x(),
            t.y(),
            t.z(),
            deg_from_rad(a.roll_rad),
            deg_from_rad(a.pitch_rad),
            deg_from_rad(a.yaw_rad)};
}

}  // namespace gripscan
