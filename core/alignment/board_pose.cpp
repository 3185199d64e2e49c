#include "core/alignment/board_pose.h"

#include <Eigen/Cholesky>
#include <cmath>
#include <opencv2/calib3d.hpp>
#include <opencv2/core/eigen.hpp>

namespace gripscan {
namespace {

CornerResidual residual_at(const RectifiedRig& camera, const Eigen::Vector3d& p, double cx_px,
                           double baseline_m, const Eigen::Vector2d& seen, std::size_t corner) {
    const double x = p.x() - baseline_m;
    CornerResidual r;
    r.corner = corner;
    r.px = Eigen::Vector2d(camera.f_px * x / p.z() + cx_px,
                           camera.f_px * p.y() / p.z() + camera.cy_px) -
           seen;
    const double s = camera.f_px / p.z();
    r.by_point << s, 0.0, -s * x / p.z(), 0.0, s, -s * p.y() / p.z();
    return r;
}

Eigen::Matrix3d skew(const Eigen::Vector3d& v) {
    Eigen::Matrix3d M;
    M << 0, -v.z(), v.y(), v.z(), 0, -v.x(), -v.y(), v.x(), 0;
    return M;
}

std::optional<Pose> first_pose(const RectifiedRig& camera, const BoardObservation& observation) {
    std::vector<cv::Point3d> board;
    std::vector<cv::Point2d> image;
    for (std::size_t i = 0; i < observation.board_m.size(); ++i) {
        const Eigen::Vector3d& p = observation.board_m[i];
        board.emplace_back(p.x(), p.y(), p.z());
        image.emplace_back((observation.left_px[i].x() - camera.cx_left_px) / camera.f_px,
                           (observation.left_px[i].y() - camera.cy_px) / camera.f_px);
    }
    cv::Mat rotation, translation;
    try {
        if (!cv::solvePnP(board, image, cv::Mat::eye(3, 3, CV_64F), cv::noArray(), rotation,
                          translation, false, cv::SOLVEPNP_IPPE)) {
            return std::nullopt;
        }
    } catch (const cv::Exception&) {
        return std::nullopt;
    }
    Eigen::Vector3d turn, shift;
    cv::cv2eigen(rotation, turn);
    cv::cv2eigen(translation, shift);
    Pose T = Pose::Identity();
    T.linear() = rotation_from_vector(turn);
    T.translation() = shift;
    if (!T.matrix().allFinite() || T.translation().z() <= 0.0) return std::nullopt;
    return T;
}

}  // namespace

std::vector<CornerResidual> corner_residuals(const RectifiedRig& camera,
                                             const BoardObservation& observation,
                                             const Pose& T_camera_board) {
    std::vector<CornerResidual> residuals;
    residuals.reserve(observation.left_px.size() + observation.right_px.size());
    for (std::size_t i = 0; i < observation.board_m.size(); ++i) {
        const Eigen::Vector3d p = T_camera_board * observation.board_m[i];
        residuals.push_back(
            residual_at(camera, p, camera.cx_left_px, 0.0, observation.left_px[i], i));
        if (observation.right_px.empty()) continue;
        residuals.push_back(residual_at(camera, p, camera.cx_right_px, camera.baseline_m,
                                        observation.right_px[i], i));
    }
    return residuals;
}

bool estimate_board_pose(const RectifiedRig& camera, BoardObservation& observation) {
    const auto start = first_pose(camera, observation);
    if (!start) return false;
    Pose T = *start;
    double rms = 0.0;
    for (int iteration = 0; iteration < 20; ++iteration) {
        Matrix6d H = Matrix6d::Zero();
        Vector6d g = Vector6d::Zero();
        const Eigen::Vector3d centre = T.translation();
        const auto residuals = corner_residuals(camera, observation, T);
        double sum = 0.0;
        for (const CornerResidual& r : residuals) {
            const Eigen::Vector3d p = T * observation.board_m[r.corner];
            Eigen::Matrix<double, 2, 6> J;
            J << -r.by_point * skew(p - centre), r.by_point;
            H += J.transpose() * J;
            g += J.transpose() * r.px;
            sum += r.px.squaredNorm();
        }
        rms = std::sqrt(sum / (2.0 * static_cast<double>(residuals.size())));
        const Vector6d step = -H.ldlt().solve(g);
        if (!step.allFinite()) return false;
        T = motion_about(step, centre) * T;
        if (step.norm() < 1e-10) break;
    }
    if (T.translation().z() <= 0.0 || !std::isfinite(rms)) return false;
    observation.T_camera_board = T;
    observation.rms_px = rms;
    return true;
}

}  // namespace gripscan
