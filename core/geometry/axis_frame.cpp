#include "core/geometry/axis_frame.h"

#include <cmath>

namespace gripscan {

Pose T_axis_camera(const Axis& axis, const Eigen::Vector3d& centroid_m) {
    const Eigen::Vector3d z = axis.direction.normalized();
    const double cos_30 = std::sqrt(0.75);
    const Eigen::Vector3d side =
        std::abs(z.x()) < cos_30 ? Eigen::Vector3d::UnitX() : Eigen::Vector3d::UnitY();
    const Eigen::Vector3d x = (side - z * z.dot(side)).normalized();
    Pose T_camera_axis = Pose::Identity();
    T_camera_axis.linear().col(0) = x;
    T_camera_axis.linear().col(1) = z.cross(x);
    T_camera_axis.linear().col(2) = z;
    T_camera_axis.translation() = axis.nearest_to(centroid_m);
    return T_camera_axis.inverse();
}

}  // namespace gripscan
