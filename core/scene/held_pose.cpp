#include "core/scene/held_pose.h"

#include <cmath>

namespace gripscan {
namespace {

/// Rotations are nearly the same: their mean settles at once.
constexpr int kRounds = 3;

}  // namespace

std::optional<HeldPose> held_pose(std::span<const HeldView> views,
                                  const Eigen::Vector3d& centre_m) {
    if (views.empty()) return std::nullopt;
    const auto n = static_cast<double>(views.size());
    const auto of = [](const HeldView& view) {
        return Pose(view.T_camera_gripper.inverse() * view.T_camera_object);
    };
    Eigen::Matrix3d R = of(views.front()).linear();
    Eigen::Vector3d middle_m = Eigen::Vector3d::Zero();
    for (int round = 0; round < kRounds; ++round) {
        Eigen::Vector3d turn = Eigen::Vector3d::Zero();
        for (const HeldView& view : views) {
            turn += rotation_vector(of(view).linear() * R.transpose()) / n;
        }
        R = rotation_from_vector(turn) * R;
    }
    for (const HeldView& view : views) middle_m += of(view) * centre_m / n;
    HeldPose held;
    held.captures = views.size();
    held.T_gripper_object.linear() = R;
    held.T_gripper_object.translation() = middle_m - R * centre_m;
    double turned = 0.0;
    double shifted = 0.0;
    for (const HeldView& view : views) {
        turned += rotation_vector(of(view).linear() * R.transpose()).squaredNorm();
        shifted += (of(view) * centre_m - middle_m).squaredNorm();
    }
    // Of the mean of n, with n − 1 degrees of freedom; a single capture shows no scatter.
    const double scale = n > 1.0 ? 1.0 / (n * (n - 1.0)) : 0.0;
    held.sd_rad = std::sqrt(turned * scale);
    held.sd_m = std::sqrt(shifted * scale);
    return held;
}

}  // namespace gripscan
