// The axis of rotation from the steps themselves: camera and arm stand still, so every step turns
// about the same line of the camera frame.
#pragma once

#include <optional>
#include <span>

#include "core/geometry/axis.h"
#include "core/geometry/pose.h"
#include "core/registration/turn_report.h"

namespace gripscan {

/// Direction: weighted mean of the rotation vectors, signs made equal, outliers among the steps
/// held down by iterated reweighting. Point: least squares of (I − R) p = t with the shift along
/// the axis left out, nearest to `centre`. The sign of the direction follows the larger part of
/// the steps. Nothing if no step turns by more than 0.1 degree.
[[nodiscard]] std::optional<AxisEstimate> estimate_axis(std::span<const Pose> steps,
                                                        const Eigen::Vector3d& centre_m);

/// How one step deviates from a turn about the common axis.
struct AxisDeviation {
    double angle_rad = 0.0;  ///< rotation angle, signed by the axis
    double tilt_rad = 0.0;   ///< between its own axis and the common one
    double offset_m = 0.0;   ///< shift across the axis, of the axis point nearest `centre`, put
                             ///< as the distance the axis itself would have to move
    double slip_m = 0.0;     ///< shift along the axis
};
[[nodiscard]] AxisDeviation deviation_from(const Axis& axis, const Pose& T);

}  // namespace gripscan
