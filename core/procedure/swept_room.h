// Whether the turning gripper has room: its radius about the axis against what stands around it.
#pragma once

#include "core/cloud/cloud.h"
#include "core/geometry/axis.h"
#include "core/geometry/box.h"
#include "core/procedure/cell_facts.h"

namespace gripscan {

/// `gripper` is the cloud inside the region, `scene` that of the whole image. Only what the camera
/// sees counts; the arm, on the side that the axis points to, does not.
[[nodiscard]] SweepFacts swept_room(const Cloud& gripper, const Cloud& scene, const Box& region,
                                    const Axis& axis);

}  // namespace gripscan
