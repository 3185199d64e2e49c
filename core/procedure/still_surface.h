// What stood still while the gripper turned: two views of a warm-up compared.
#pragma once

#include "core/cloud/cloud.h"
#include "core/geometry/axis.h"

namespace gripscan {

/// Points of the first view. What looks the same turned and not turned is in neither.
struct StillSurface {
    Cloud beside;  ///< beside the gripper
    Cloud at_arm;  ///< on the side that the axis points to: beyond most of what turned
};

/// `turn_rad` about the axis leads from the first view to the second; needs some degrees.
[[nodiscard]] StillSurface still_surface(const Cloud& first, const Cloud& second, const Axis& axis,
                                         double turn_rad);

}  // namespace gripscan
