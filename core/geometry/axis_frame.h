// The frame of a template that does not depend on where the camera stood.
#pragma once

#include "core/geometry/axis.h"

namespace gripscan {

/// Origin: the axis point nearest `centroid_m`. z: along the axis. x: the camera's x made
/// perpendicular to z; where the axis is within 30° of the camera's x, the camera's y takes its
/// place.
[[nodiscard]] Pose T_axis_camera(const Axis& axis, const Eigen::Vector3d& centroid_m);

}  // namespace gripscan
