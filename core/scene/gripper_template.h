// The registered gripper as the scene knows it: its points made ready, the axis it turns about, and
// where the joint stood.
#pragma once

#include <optional>
#include <string>

#include "core/base/result.h"
#include "core/cloud/cloud.h"
#include "core/geometry/axis.h"
#include "core/scene/oriented_cuboid.h"

namespace gripscan {

/// In the camera frame of its own registration, the gripper as in that session's first capture.
struct GripperTemplate {
    Cloud cloud;                       ///< with normals
    Cloud thin;                        ///< the same with fewer points, for matching
    Axis axis;                         ///< of joint 6; right-hand rule for its positive turn
    std::optional<double> joint6_rad;  ///< at which the gripper stands like this
    OrientedCuboid cuboid;             ///< around the points, along the axis; no margins

    std::string file;   ///< as the session names it
    std::string check;  ///< sum of the file's bytes
};

/// Errors: too few points to be matched.
[[nodiscard]] Result<GripperTemplate> make_gripper_template(Cloud cloud, const Axis& axis,
                                                            std::optional<double> joint6_rad);

}  // namespace gripscan
