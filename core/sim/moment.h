// How the cell stands while an image is exposed: all that the camera can notice.
#pragma once

#include <map>

#include "core/sim/cell_layout.h"
#include "core/sim/scene_model.h"

namespace gripscan::sim {

struct Moment {
    JointAngles true_rad{};
    Pose T_tool_part = Pose::Identity();    ///< what is mounted, in tool0; identity: as mounted
    Pose T_part_object = Pose::Identity();  ///< what is held, in tool0; identity: as it was gripped
    Pose T_camera_moved = Pose::Identity();  ///< the camera in the frame it had at the start
    bool intruder = false;                   ///< the strange thing is there, if the cell has one
    bool tool = false;                       ///< the tool is left there, if the cell has one
    Eigen::Vector3d surroundings_shift_m = Eigen::Vector3d::Zero();  ///< in WORLD
    double defocus_px = 0.0;                 ///< standard deviation of additional blur
    double glare_px = 0.0;                   ///< radius of a saturated spot; 0: none
};

/// At every capture grabbed so far, by its index; a retake replaces the one before.
using Moments = std::map<int, Moment>;

/// T_world_body of all bodies; a strange thing that has not come is far away.
[[nodiscard]] std::array<Pose, SceneModel::kBodies> body_poses(const Moment& moment);

[[nodiscard]] inline Pose T_world_camera(const CellLayout& layout, const Moment& moment) {
    return layout.T_world_camera * moment.T_camera_moved;
}

/// What turns and is mounted on the flange, in the camera frame.
[[nodiscard]] Pose T_camera_part(const CellLayout& layout, const Moment& moment);
/// What the gripper holds, in the camera frame.
[[nodiscard]] inline Pose T_camera_object(const CellLayout& layout, const Moment& moment) {
    return T_camera_part(layout, moment) * moment.T_part_object;
}

}  // namespace gripscan::sim
