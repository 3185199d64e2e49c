// What gripscan wants of a robot: say where the joints are, and turn the last one.
#pragma once

#include <array>

#include "core/base/result.h"
#include "core/geometry/pose.h"

namespace gripscan {

/// J1 … J6 in rad, FANUC convention (J3 is measured against the horizontal: J3_urdf = J3 + J2).
using JointAngles = std::array<double, 6>;

/// A standing robot, as it reports itself.
struct RobotReading {
    JointAngles joints_rad{};
    Pose T_world_tool = Pose::Identity();  ///< tool0 in FANUC WORLD, m
};

class RobotLink {
  public:
    virtual ~RobotLink() = default;
    [[nodiscard]] virtual Result<RobotReading> read() = 0;
    /// Turns joint 6 to an absolute angle and returns the reading once the arm stands still.
    [[nodiscard]] virtual Result<RobotReading> turn_joint6_to(double angle_rad) = 0;
};

}  // namespace gripscan
