// The built-in objects that a gripper can hold, in its grasp frame: origin between the fingers,
// x along their stroke, z away from the flange.
#pragma once

#include <string>
#include <vector>

#include "core/sim/part.h"

namespace gripscan::sim {

[[nodiscard]] std::vector<std::string> object_names();

/// The object, as wide as the opening where it is held; an opening of 0 means suction, and the
/// object hangs with its back at z = 0. A name that is none of object_names() gives no parts.
[[nodiscard]] std::vector<Part> make_object(const std::string& name, double opening_m);

}  // namespace gripscan::sim
