// Between the messages of GSP/1 (mm, deg, what is unknown left out) and what gripscan works with.
#pragma once

#include "core/robot/gsp_message.h"

namespace gripscan::gsp {

/// All joints must be known. The pose is the controller's where it is complete and in WORLD (user
/// frame 0), else it follows from the joints.
[[nodiscard]] RobotResult<RobotReading> reading_from(const Position& position);
/// For a controller: in WORLD.
[[nodiscard]] Position position_from(const RobotReading& reading, std::int64_t time_ms,
                                     int utool = 1);

/// X Y Z in mm, W P R in deg. At |P| = 90 deg R is 0.
[[nodiscard]] std::array<double, 6> xyzwpr_from_pose(const Pose& T);
[[nodiscard]] Pose pose_from_xyzwpr(const std::array<double, 6>& xyzwpr);

/// What the controller does not know counts as what forbids a motion.
[[nodiscard]] ControllerState state_from(const StateReply& reply);

}  // namespace gripscan::gsp
