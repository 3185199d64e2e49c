#include "core/geometry/pose.h"

#include <Eigen/SVD>
#include <cmath>

namespace gripscan {

EulerAngles euler_from_rotation(const Eigen::Matrix3d& R) {
    EulerAngles angles;
    const double cos_pitch = std::hypot(R(0, 0), R(1, 0));
    angles.pitch_rad = std::atan2(-R(2, 0), cos_pitch);
    if (cos_pitch > 1e-9) {
        angles.roll_rad = std::atan2(R(2, 1), R(2, 2));
        angles.yaw_rad = std::atan2(R(1, 0), R(0, 0));
    } else {
        angles.roll_rad = std::atan2(-R(1, 2), R(1, 1));
    }
    return angles;
}

Eigen::Matrix3d rotation_from_euler(const EulerAngles& angles) {
    return (Eigen::AngleAxisd(angles.yaw_rad, Eigen::Vector3d::UnitZ()) *
            Eigen::AngleAxisd(angles.pitch_rad, Eigen::Vector3d::UnitY()) *
            Eigen::AngleAxisd(angles.roll_rad, Eigen::Vector3d::UnitX()))
        .toRotationMatrix();
}

double rotation_angle_rad(const Eigen::Matrix3d& R) { return rotation_vector(R).norm(); }

Eigen::Vector3d rotation_vector(const Eigen::Matrix3d& R) {
    const Eigen::Quaterniond q(R);
    const double sine = q.vec().norm();
    const double sign = q.w() < 0.0 ? -1.0 : 1.0;
    const double angle = 2.0 * std::atan2(sine, std::abs(q.w()));
    // sin(x)/x → 1: below this the quotient is 2 to machine precision.
    const double scale = sine > 1e-12 ? angle / sine : 2.0;
    return sign * scale * q.vec();
}

Eigen::Matrix3d rotation_from_vector(const Eigen::Vector3d& rotation_vector_rad) {
    const double angle = rotation_vector_rad.norm();
    if (angle < 1e-300) return Eigen::Matrix3d::Identity();
    return Eigen::AngleAxisd(angle, rotation_vector_rad / angle).toRotationMatrix();
}

Pose motion_about(const Vector6d& omega_v, const Eigen::Vector3d& centre) {
    Pose T = Pose::Identity();
    T.linear() = rotation_from_vector(omega_v.head<3>());
    T.translation() = centre - T.linear() * centre + omega_v.tail<3>();
    return T;
}

std::array<double, 16> row_major_from_pose(const Pose& T) {
    std::array<double, 16> numbers{};
    Eigen::Map<Eigen::Matrix<double, 4, 4, Eigen::RowMajor>>(numbers.data()) = T.matrix();
    return numbers;
}

std::optional<Pose> pose_from_row_major(const std::array<double, 16>& numbers) {
    const Eigen::Matrix4d M =
        Eigen::Map<const Eigen::Matrix<double, 4, 4, Eigen::RowMajor>>(numbers.data());
    if (!M.allFinite() || (M.row(3) - Eigen::RowVector4d(0, 0, 0, 1)).norm() > 1e-6) return {};
    const Eigen::Matrix3d A = M.topLeftCorner<3, 3>();
    const Eigen::JacobiSVD<Eigen::Matrix3d> svd(A, Eigen::ComputeFullU | Eigen::ComputeFullV);
    const Eigen::Matrix3d R = svd.matrixU() * svd.matrixV().transpose();
    if (R.determinant() < 0.0 || (R - A).norm() > 1e-6) return {};
    Pose T = Pose::Identity();
    T.linear() = R;
    T.translation() = M.topRightCorner<3, 1>();
    return T;
}

}  // namespace gripscan
