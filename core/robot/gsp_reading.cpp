#include "core/robot/gsp_reading.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/base/units.h"
#include "core/robot/kinematics.h"

namespace gripscan::gsp {

RobotResult<RobotReading> reading_from(const Position& position) {
    RobotReading reading;
    for (std::size_t i = 0; i < 6; ++i) {
        if (!position.joints_deg[i]) {
            return tl::unexpected<RobotError>(RobotError{
                RobotFault::kProtocol, 0, 0,
                fmt::format("the controller does not know its joint {}: it needs six axes and a "
                            "mastered arm",
                            i + 1)});
        }
        reading.joints_rad[i] = rad_from_deg(*position.joints_deg[i]);
    }
    std::array<double, 6> xyzwpr{};
    bool known = position.uframe == 0;
    for (std::size_t i = 0; i < 6; ++i) {
        known = known && position.xyzwpr[i];
        xyzwpr[i] = position.xyzwpr[i].value_or(0.0);
    }
    reading.T_world_tool = known ? pose_from_xyzwpr(xyzwpr) : tool_pose(reading.joints_rad);
    return reading;
}

Position position_from(const RobotReading& reading, std::int64_t time_ms, int utool) {
    Position position;
    position.time_ms = time_ms;
    const auto xyzwpr = xyzwpr_from_pose(reading.T_world_tool);
    for (std::size_t i = 0; i < 6; ++i) {
        position.joints_deg[i] = deg_from_rad(reading.joints_rad[i]);
        position.xyzwpr[i] = xyzwpr[i];
    }
    position.uframe = 0;
    position.utool = utool;
    return position;
}

std::array<double, 6> xyzwpr_from_pose(const Pose& T) {
    const Eigen::Vector3d xyz_mm = T.translation() * kMmPerM;
    const EulerAngles wpr = euler_from_rotation(T.linear());
    return {xyz_mm.x(),
            xyz_mm.y(),
            xyz_mm.z(),
            deg_from_rad(wpr.roll_rad),
            deg_from_rad(wpr.pitch_rad),
            deg_from_rad(wpr.yaw_rad)};
}

Pose pose_from_xyzwpr(const std::array<double, 6>& xyzwpr) {
    const auto& [x_mm, y_mm, z_mm, w_deg, p_deg, r_deg] = xyzwpr;
    Pose T = Pose::Identity();
    T.translation() = Eigen::Vector3d(x_mm, y_mm, z_mm) / kMmPerM;
    T.linear() =
        rotation_from_euler({rad_from_deg(w_deg), rad_from_deg(p_deg), rad_from_deg(r_deg)});
    return T;
}

ControllerState state_from(const StateReply& reply) {
    ControllerState state;
    state.automatic = reply.automatic.value_or(false);
    state.servo_on = reply.servo_on.value_or(false);
    state.emergency_stop = reply.emergency_stop.value_or(true);
    state.fault = reply.fault.value_or(true);
    state.moving = reply.moving.value_or(true);
    state.override_percent = reply.override_percent.value_or(0);
    state.alarm = reply.alarm;
    return state;
}

}  // namespace gripscan::gsp
