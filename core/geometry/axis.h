// A directed line in space: the axis of a turn.
#pragma once

#include <Eigen/Core>

#include "core/geometry/pose.h"

namespace gripscan {

/// Points x = point + s · direction; direction is a unit vector, right-hand rule for the turn.
struct Axis {
    Eigen::Vector3d point_m = Eigen::Vector3d::Zero();
    Eigen::Vector3d direction = Eigen::Vector3d::UnitX();

    /// Where along the axis p lies, from `point_m`.
    [[nodiscard]] double along_m(const Eigen::Vector3d& p_m) const {
        return direction.dot(p_m - point_m);
    }
    [[nodiscard]] Eigen::Vector3d nearest_to(const Eigen::Vector3d& p_m) const {
        return point_m + direction * along_m(p_m);
    }
    [[nodiscard]] double distance_m(const Eigen::Vector3d& p_m) const {
        return (p_m - nearest_to(p_m)).norm();
    }
};

/// The turn by an angle about the axis.
[[nodiscard]] inline Pose turn_about(const Axis& axis, double angle_rad) {
    Pose T = Pose::Identity();
    T.linear() = Eigen::AngleAxisd(angle_rad, axis.direction).toRotationMatrix();
    T.translation() = axis.point_m - T.linear() * axis.point_m;
    return T;
}

}  // namespace gripscan
