#include "core/sim/moment.h"

#include "core/robot/kinematics.h"

namespace gripscan::sim {

std::array<Pose, SceneModel::kBodies> body_poses(const Moment& moment) {
    auto T_world_body = body_poses(moment.true_rad);
    T_world_body[SceneModel::kTool] = T_world_body[SceneModel::kTool] * moment.T_tool_part;
    T_world_body[SceneModel::kObject] = T_world_body[SceneModel::kTool] * moment.T_part_object;
    if (!moment.intruder) {
        constexpr double kAway_m = 100.0;  // below the floor
        T_world_body[SceneModel::kIntruder] = Pose(Eigen::Translation3d(0, 0, -kAway_m));
    }
    return T_world_body;
}

Pose T_camera_part(const CellLayout& layout, const Moment& moment) {
    return T_world_camera(layout, moment).inverse() * tool_pose(moment.true_rad) *
           moment.T_tool_part;
}

}  // namespace gripscan::sim
