// The built-in grippers, in the frame tool0: origin on the flange's face, z out of it.
#pragma once

#include <string>
#include <vector>

#include "core/sim/part.h"

namespace gripscan::sim {

struct Gripper {
    std::vector<Part> parts;
    /// Where an object is held: origin between the fingers, x along their stroke, z away from the
    /// flange.
    Pose T_tool_grasp = Pose::Identity();
    double opening_m = 0.0;  ///< between the fingers' inner faces; 0: holds by suction
};

[[nodiscard]] std::vector<std::string> gripper_names();
/// `name` is one of gripper_names(); anything else gives no parts.
[[nodiscard]] Gripper make_gripper(const std::string& name);

}  // namespace gripscan::sim
