#include "core/alignment/robot_alignment.h"

#include <Eigen/Cholesky>
#include <cmath>
#include <limits>
#include <optional>

#include "core/alignment/board_pose.h"
#include "core/base/units.h"

namespace gripscan {
namespace {

using Vector12d = Eigen::Matrix<double, 12, 1>;
using Matrix12d = Eigen::Matrix<double, 12, 12>;

Eigen::Matrix3d skew(const Eigen::Vector3d& v) {
    Eigen::Matrix3d M;
    M << 0, -v.z(), v.y(), v.z(), 0, -v.x(), -v.y(), v.x(), 0;
    return M;
}

Pose small_motion(const Vector6d& omega_v) {
    return motion_about(omega_v, Eigen::Vector3d::Zero());
}

/// Normal equations of all corners: X ← X · exp(ξ), Y ← Y · exp(η).
struct Normal {
    Matrix12d H = Matrix12d::Zero();
    Vector12d g = Vector12d::Zero();
    double sum_px2 = 0.0;
    std::size_t corners = 0;
};

Normal normal_equations(std::span<const AlignmentView> views, const RectifiedRig& camera,
                        Mounting mounting, const HandEyePoses& poses) {
    Normal normal;
    for (const AlignmentView& view : views) {
        const Pose A = fixed_side({view.T_robot_flange, {}}, mounting);
        const Pose T_camera_board = poses.X.inverse() * A.inverse() * poses.Y;
        for (const CornerResidual& r : corner_residuals(camera, view.board, T_camera_board)) {
            const Eigen::Vector3d& b = view.board.board_m[r.corner];
            const Eigen::Vector3d p = T_camera_board * b;
            Eigen::Matrix<double, 2, 12> J;
            J << r.by_point * skew(p), -r.by_point, -r.by_point * T_camera_board.linear() * skew(b),
                r.by_point * T_camera_board.linear();
            normal.H += J.transpose() * J;
            normal.g += J.transpose() * r.px;
            normal.sum_px2 += r.px.squaredNorm();
            ++normal.corners;
        }
    }
    return normal;
}

/// Levenberg and Marquardt.
HandEyePoses refined(std::span<const AlignmentView> views, const RectifiedRig& camera,
                     Mounting mounting, HandEyePoses poses) {
    double damping = 1e-6;
    Normal normal = normal_equations(views, camera, mounting, poses);
    for (int iteration = 0; iteration < 60; ++iteration) {
        Matrix12d damped = normal.H;
        damped.diagonal() *= 1.0 + damping;
        const Vector12d step = -damped.ldlt().solve(normal.g);
        if (!step.allFinite()) break;
        const HandEyePoses next{poses.X * small_motion(step.head<6>()),
                                poses.Y * small_motion(step.tail<6>())};
        const Normal tried = normal_equations(views, camera, mounting, next);
        if (!(tried.sum_px2 <= normal.sum_px2)) {
            damping *= 10.0;
            if (damping > 1e6) break;
            continue;
        }
        poses = next;
        normal = tried;
        damping = std::max(1e-9, damping * 0.2);
        if (step.norm() < 1e-10) break;
    }
    return poses;
}

std::vector<HandEyeView> hand_eye_views(std::span<const AlignmentView> views) {
    std::vector<HandEyeView> result;
    for (const AlignmentView& view : views) {
        result.push_back({view.T_robot_flange, view.board.T_camera_board});
    }
    return result;
}

/// From other views, in the way that was chosen for all of them.
std::optional<HandEyePoses> estimate_again(std::span<const AlignmentView> views,
                                           const RectifiedRig& camera,
                                           const RobotAlignment& alignment) {
    if (alignment.refined) return refined(views, camera, alignment.mounting, alignment.poses);
    const auto candidates = solve_hand_eye(hand_eye_views(views), alignment.mounting);
    if (!candidates) return std::nullopt;
    for (const HandEyeCandidate& candidate : *candidates) {
        if (candidate.method == alignment.start) return candidate.poses;
    }
    return std::nullopt;
}

/// Jackknife: what the result would be without each view. It needs no model of the robot's errors,
/// which are the same for all corners of a view.
void measure_uncertainty(std::span<const AlignmentView> views, const RectifiedRig& camera,
                         RobotAlignment& alignment) {
    const auto n = static_cast<double>(views.size());
    std::vector<Vector6d> differences;
    Vector6d mean = Vector6d::Zero();
    for (std::size_t left_out = 0; left_out < views.size(); ++left_out) {
        std::vector<AlignmentView> others;
        for (std::size_t i = 0; i < views.size(); ++i) {
            if (i != left_out) others.push_back(views[i]);
        }
        const auto without = estimate_again(others, camera, alignment);
        if (!without) continue;
        const Pose apart = alignment.poses.X.inverse() * without->X;
        Vector6d d;
        d << rotation_vector(apart.linear()),
            without->X.translation() - alignment.poses.X.translation();
        differences.push_back(d);
    }
    // Views without which nothing can be told: the result is as uncertain as can be.
    if (differences.size() < views.size()) {
        alignment.sd_rad = alignment.sd_m = std::numeric_limits<double>::infinity();
        return;
    }
    for (const Vector6d& d : differences) mean += d / n;
    Vector6d squares = Vector6d::Zero();
    for (const Vector6d& d : differences) squares += (d - mean).cwiseAbs2();
    squares *= (n - 1.0) / n;
    alignment.sd_rad = std::sqrt(squares.head<3>().sum());
    alignment.sd_m = std::sqrt(squares.tail<3>().sum());
}

void judge(const AlignmentLimits& limits, RobotAlignment& alignment) {
    const BoardSpread& spread = alignment.spread;
    if (spread.rms_m > limits.spread_m || spread.rms_rad > limits.spread_rad) {
        alignment.reason = fmt::format(
            "the views disagree where the board is by {:.1f} mm and {:.2f} deg (limits {:.1f} mm, "
            "{:.2f} deg): do poses and images belong together, is the board fixed, its size right?",
            kMmPerM * spread.rms_m, deg_from_rad(spread.rms_rad), kMmPerM * limits.spread_m,
            deg_from_rad(limits.spread_rad));
    } else if (alignment.sd_m > limits.sd_m) {
        alignment.reason = fmt::format(
            "the position is known to {:.1f} mm only (limit {:.1f} mm): take more views, and turn "
            "the flange further about different axes",
            kMmPerM * alignment.sd_m, kMmPerM * limits.sd_m);
    }
    alignment.rejected = !alignment.reason.empty();
}

}  // namespace

Result<RobotAlignment> align_robot(std::span<const AlignmentView> views, const RectifiedRig& camera,
                                   Mounting mounting, const AlignmentLimits& limits,
                                   const Progress& progress) {
    const auto poses = hand_eye_views(views);
    auto candidates = solve_hand_eye(poses, mounting);
    if (!candidates) return forward_error(candidates.error());
    if (progress.cancelled()) return cancelled_error();
    RobotAlignment alignment;
    alignment.mounting = mounting;
    const HandEyeCandidate& best = best_of(*candidates);
    alignment.start = best.method;
    alignment.poses = best.poses;
    alignment.spread = best.spread;
    const HandEyePoses refined_poses = refined(views, camera, mounting, best.poses);
    const BoardSpread refined_spread = board_spread(poses, mounting, refined_poses);
    constexpr double kNotWorse = 1.05;
    if (refined_spread.cost_m() <= kNotWorse * best.spread.cost_m() + 1e-9) {
        alignment.refined = true;
        alignment.poses = refined_poses;
        alignment.spread = refined_spread;
    }
    const Normal normal = normal_equations(views, camera, mounting, alignment.poses);
    alignment.reprojection_px =
        std::sqrt(normal.sum_px2 / (2.0 * static_cast<double>(normal.corners)));
    double squares = 0.0;
    for (const AlignmentView& view : views) squares += view.board.rms_px * view.board.rms_px;
    alignment.board_px = std::sqrt(squares / static_cast<double>(views.size()));
    measure_uncertainty(views, camera, alignment);
    alignment.candidates = std::move(*candidates);
    judge(limits, alignment);
    return alignment;
}

}  // namespace gripscan
