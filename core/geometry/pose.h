// Poses and the numbers people read from them. T_target_source maps: x_target = T · x_source.
#pragma once

#include <Eigen/Geometry>
#include <array>
#include <optional>

namespace gripscan {

using Pose = Eigen::Isometry3d;
using Vector6d = Eigen::Matrix<double, 6, 1>;
using Matrix6d = Eigen::Matrix<double, 6, 6>;

/// Angles of R = Rz(yaw) · Ry(pitch) · Rx(roll), in rad; also FANUC's W P R (= roll pitch yaw).
struct EulerAngles {
    double roll_rad = 0.0;
    double pitch_rad = 0.0;
    double yaw_rad = 0.0;
};

/// pitch in [−π/2, π/2]; at |pitch| = π/2 yaw is set to 0.
[[nodiscard]] EulerAngles euler_from_rotation(const Eigen::Matrix3d& R);
[[nodiscard]] Eigen::Matrix3d rotation_from_euler(const EulerAngles& angles);

/// Rotation angle in [0, π], exact for small angles too.
[[nodiscard]] double rotation_angle_rad(const Eigen::Matrix3d& R);
/// Axis times angle, in rad.
[[nodiscard]] Eigen::Vector3d rotation_vector(const Eigen::Matrix3d& R);
[[nodiscard]] Eigen::Matrix3d rotation_from_vector(const Eigen::Vector3d& rotation_vector_rad);

/// A small motion [ω; v] (rad, m) applied about `centre`: x → exp(ω)(x − c) + c + v.
[[nodiscard]] Pose motion_about(const Vector6d& omega_v, const Eigen::Vector3d& centre);

/// 16 numbers, row-major, as in the files.
[[nodiscard]] std::array<double, 16> row_major_from_pose(const Pose& T);
/// Nothing if the numbers are not a rigid motion to 1e-6 (the rotation is re-orthonormalised).
[[nodiscard]] std::optional<Pose> pose_from_row_major(const std::array<double, 16>& numbers);

}  // namespace gripscan
