#include "core/registration/grip_slip.h"

#include <algorithm>
#include <cmath>

#include "core/registration/align_surfaces.h"
#include "core/registration/fits_as_well.h"

namespace gripscan {
namespace {

constexpr double kShareOfSlipLimit = 0.5;
/// Errors of the surfaces that do not average out, as a share of the turn; the same as of a step.
constexpr double kSystematicShare = 0.004;
constexpr double kNoMotion = 1e-12;

Eigen::Matrix3d skew(const Eigen::Vector3d& v) {
    Eigen::Matrix3d m;
    m << 0, -v.z(), v.y(), v.z(), 0, -v.x(), -v.y(), v.x(), 0;
    return m;
}

/// The same motion's covariance about another centre.
Matrix6d about(const Matrix6d& covariance, const Eigen::Vector3d& from_m,
               const Eigen::Vector3d& to_m) {
    Matrix6d J = Matrix6d::Identity();
    J.bottomLeftCorner<3, 3>() = -skew(to_m - from_m);
    return J * covariance * J.transpose();
}

/// Standard deviation along v.
double sigma_along(const Eigen::Matrix3d& covariance, const Eigen::Vector3d& v) {
    if (v.norm() < kNoMotion) return std::sqrt(covariance.trace() / 3.0);
    const Eigen::Vector3d unit = v.normalized();
    return std::sqrt(std::max(0.0, unit.dot(covariance * unit)));
}

}  // namespace

std::optional<GripSlip> measure_grip_slip(const PreparedView& from, const PreparedView& to,
                                          const Alignment& part, const AlignSettings& settings) {
    const auto& a = from.holder;
    const auto& b = to.holder;
    if (!a || !b || !a->usable() || !b->usable() || !part.found) return std::nullopt;
    const Alignment gripper = finish_alignment(
        a->surface, b->surface, b->T_camera_holder * a->T_camera_holder.inverse(), settings);
    // Where the part is, against where the gripper would have carried it.
    const Pose& T = part.T_target_source;
    const Pose& T_carried = gripper.T_target_source;
    const Eigen::Vector3d centre_m = T.inverse() * part.centre_m;
    const Eigen::Vector3d shift_m = T * centre_m - T_carried * centre_m;
    const Eigen::Vector3d turn_rad = rotation_vector(T.linear() * T_carried.linear().transpose());
    const Matrix6d covariance =
        part.covariance + about(gripper.covariance, gripper.centre_m, part.centre_m);
    GripSlip slip;
    slip.shift_m = shift_m.norm();
    slip.angle_rad = turn_rad.norm();
    slip.sigma_shift_m = sigma_along(covariance.bottomRightCorner<3, 3>(), shift_m);
    slip.sigma_angle_rad = std::hypot(sigma_along(covariance.topLeftCorner<3, 3>(), turn_rad),
                                      kSystematicShare * part.angle_rad);
    if (fits_as_well(from.surface, to.surface, part, T_carried, settings)) {
        // A difference that the surfaces do not resolve is its own uncertainty.
        slip.sigma_shift_m = std::max(slip.sigma_shift_m, slip.shift_m);
        slip.sigma_angle_rad = std::max(slip.sigma_angle_rad, slip.angle_rad);
    }
    return slip;
}

double grip_shift_limit_m(const GripSlip& slip, const TurnLimits& limits) {
    return std::max(kShareOfSlipLimit * limits.slip_m, limits.sigmas * slip.sigma_shift_m);
}

double grip_angle_limit_rad(const GripSlip& slip, const TurnLimits& limits) {
    return std::max(limits.angle_rad, limits.sigmas * slip.sigma_angle_rad);
}

bool slipped(const GripSlip& slip, const TurnLimits& limits) {
    return slip.shift_m > grip_shift_limit_m(slip, limits) ||
           slip.angle_rad > grip_angle_limit_rad(slip, limits);
}

}  // namespace gripscan
