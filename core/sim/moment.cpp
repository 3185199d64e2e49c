#include "core/sim/moment.h"

#include "core/robot/kinematics.h"

namespace gripscan::sim {

std::array<Pose, SceneModel::kBodies> body_poses(const Moment& moment) {
    auto T_world_body = body_poses(moment.true_rad);
    T_world_body[SceneModel::kTool] = T_world_body[SceneModel::kTool] * moment.T_tool_part;
    constexpr double kAway_m = 100.0;  // below the floor
    const Pose away(Eigen::Translation3d(0, 0, -kAway_m));
    if (!moment.intruder) T_world_body[SceneModel::kIntruder] = away;
    if (!moment.tool) T_world_body[SceneModel::kLeftTool] = away;
    T_world_body[SceneModel::kSurroundings].translation() = moment.surroundings_shift_m;
    T_world_body[SceneModel::kObject] = T_world_body[SceneModel::kTool] * moment.T_part_object;
    return T_world_body;
}

Pose T_camera_part(const CellLayout& layout, const Moment& moment) {
    return T_world_camera(layout, moment).inverse() * tool_pose(moment.true_rad) *
           moment.T_tool_part;
}

}  // namespace gripscan::sim
