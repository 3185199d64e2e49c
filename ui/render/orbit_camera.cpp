#include "ui/render/orbit_camera.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace gripscan::ui {
namespace {

constexpr double kHalfPi = 0.5 * std::numbers::pi;
constexpr double kNearestPivot_m = 0.005;  ///< the pivot is never nearer to the eye
constexpr double kFarthestPivot_m = 100.0;
constexpr double kZoomPerClick = 0.85;  ///< of the distance to the anchor

/// Yaw and pitch that look along a direction of the home frame.
void look_along(OrbitCamera& camera, const Eigen::Vector3d& forward_world) {
    const Eigen::Vector3d f = camera.R_world_home.transpose() * forward_world.normalized();
    camera.pitch_rad = std::asin(std::clamp(f.y(), -1.0, 1.0));
    // Straight up or down every yaw looks the same way: the one that was is kept.
    if (std::hypot(f.x(), f.z()) > 1e-9) camera.yaw_rad = std::atan2(f.x(), f.z());
}

}  // namespace

Eigen::Matrix3d OrbitCamera::R_world_view() const {
    const double sy = std::sin(yaw_rad);
    const double cy = std::cos(yaw_rad);
    const double sp = std::sin(pitch_rad);
    const double cp = std::cos(pitch_rad);
    Eigen::Matrix3d R;  // columns: right, down, forward
    R.col(0) = Eigen::Vector3d(cy, 0.0, -sy);
    R.col(2) = Eigen::Vector3d(cp * sy, sp, cp * cy);
    R.col(1) = R.col(2).cross(R.col(0));
    return R_world_home * R;
}

Eigen::Vector3d OrbitCamera::eye_m() const {
    return pivot_m - distance_m * R_world_view().col(2);
}

Pose OrbitCamera::T_view_world() const {
    Pose T = Pose::Identity();
    T.linear() = R_world_view().transpose();
    T.translation() = -T.linear() * eye_m();
    return T;
}

double OrbitCamera::px_per_m(const Viewport& viewport) const {
    return 0.5 * viewport.height_px / (std::tan(0.5 * fov_y_rad) * distance_m);
}

OrbitCamera orbited(const OrbitCamera& camera, double dx_px, double dy_px,
                    const Viewport& viewport) {
    const double rad_per_px = std::numbers::pi / std::max(1.0, viewport.height_px);
    OrbitCamera moved = camera;
    moved.yaw_rad = std::remainder(camera.yaw_rad + dx_px * rad_per_px, 2.0 * std::numbers::pi);
    moved.pitch_rad = std::clamp(camera.pitch_rad + dy_px * rad_per_px, -kHalfPi, kHalfPi);
    return moved;
}

OrbitCamera panned(const OrbitCamera& camera, double dx_px, double dy_px,
                   const Viewport& viewport) {
    const Eigen::Matrix3d R = camera.R_world_view();
    OrbitCamera moved = camera;
    moved.pivot_m -= (R.col(0) * dx_px + R.col(1) * dy_px) / camera.px_per_m(viewport);
    return moved;
}

OrbitCamera zoomed(const OrbitCamera& camera, double clicks, const Eigen::Vector2d& cursor_px,
                   const Viewport& viewport, const std::optional<Eigen::Vector3d>& anchor_m) {
    const Eigen::Vector3d forward = camera.R_world_view().col(2);
    const Eigen::Vector3d eye = camera.eye_m();
    Eigen::Vector3d anchor =
        anchor_m.value_or(unproject(camera, viewport, cursor_px, camera.distance_m));
    if (forward.dot(anchor - eye) <= 0.0) {
        anchor = unproject(camera, viewport, cursor_px, camera.distance_m);
    }
    const Eigen::Vector3d to_anchor = anchor - eye;
    double travel = to_anchor.norm() * (1.0 - std::pow(kZoomPerClick, clicks));
    // The last millimetres are no wall: every click moves on.
    if (clicks > 0.0) travel = std::max(travel, clicks * 0.2 * kNearestPivot_m);
    const Eigen::Vector3d new_eye = eye + travel * to_anchor.normalized();

    OrbitCamera moved = camera;
    const double scale = 1.0 - travel / to_anchor.norm();
    moved.distance_m = std::clamp(camera.distance_m * scale, kNearestPivot_m, kFarthestPivot_m);
    moved.pivot_m = new_eye + moved.distance_m * forward;
    return moved;
}

OrbitCamera with_pivot(const OrbitCamera& camera, const Eigen::Vector3d& point_m) {
    OrbitCamera moved = camera;
    const double depth = camera.R_world_view().col(2).dot(point_m - camera.eye_m());
    moved.distance_m = std::clamp(depth, kNearestPivot_m, kFarthestPivot_m);
    moved.pivot_m = point_m;
    return moved;
}

OrbitCamera fitted(const OrbitCamera& camera, const Box& box, const Viewport& viewport) {
    if (!box.min_m.allFinite() || !box.max_m.allFinite()) return camera;
    OrbitCamera moved = camera;
    moved.pivot_m = 0.5 * (box.min_m + box.max_m);
    const double radius = std::max(0.5 * (box.max_m - box.min_m).norm(), kNearestPivot_m);
    const double half_y = 0.5 * camera.fov_y_rad;
    const double aspect = viewport.width_px / std::max(1.0, viewport.height_px);
    const double half = std::atan(std::tan(half_y) * std::min(1.0, aspect));
    moved.distance_m = std::clamp(radius / std::sin(half), kNearestPivot_m, kFarthestPivot_m);
    return moved;
}

OrbitCamera axis_view(const OrbitCamera& camera, AxisView view) {
    OrbitCamera moved = camera;
    moved.yaw_rad = view == AxisView::kSide ? -kHalfPi : 0.0;
    moved.pitch_rad = view == AxisView::kTop ? kHalfPi : 0.0;
    return moved;
}

OrbitCamera looking_along(const OrbitCamera& camera, const Axis& axis) {
    OrbitCamera moved = camera;
    moved.pivot_m = axis.nearest_to(camera.pivot_m);
    look_along(moved, axis.direction);
    return moved;
}

OrbitCamera from_stereo_camera(const OrbitCamera& camera, double depth_m) {
    OrbitCamera moved = camera;
    look_along(moved, Eigen::Vector3d::UnitZ());
    moved.distance_m = std::clamp(depth_m, kNearestPivot_m, kFarthestPivot_m);
    moved.pivot_m = moved.distance_m * Eigen::Vector3d::UnitZ();
    return moved;
}

ClipRange clip_range(const OrbitCamera& camera, const Eigen::Vector3d& centre_m, double radius_m) {
    constexpr double kLargestRatio = 20000.0;
    const double depth = camera.R_world_view().col(2).dot(centre_m - camera.eye_m());
    const double far = std::max(depth + radius_m, 2.0 * camera.distance_m);
    const double near = std::max(0.9 * (depth - radius_m), far / kLargestRatio);
    return {std::min(near, 0.5 * camera.distance_m), far};
}

Eigen::Matrix4d clip_from_world(const OrbitCamera& camera, const Viewport& viewport,
                                const ClipRange& range) {
    const double f = 1.0 / std::tan(0.5 * camera.fov_y_rad);
    const double aspect = viewport.width_px / std::max(1.0, viewport.height_px);
    const double n = range.near_m;
    const double d = range.far_m;
    Eigen::Matrix4d clip_from_view = Eigen::Matrix4d::Zero();
    clip_from_view(0, 0) = f / aspect;
    clip_from_view(1, 1) = -f;  // y down becomes y up
    clip_from_view(2, 2) = (d + n) / (d - n);
    clip_from_view(2, 3) = -2.0 * d * n / (d - n);
    clip_from_view(3, 2) = 1.0;
    return clip_from_view * camera.T_view_world().matrix();
}

std::optional<Eigen::Vector2d> project(const OrbitCamera& camera, const Viewport& viewport,
                                       const Eigen::Vector3d& point_m) {
    const Eigen::Vector3d p = camera.T_view_world() * point_m;
    if (p.z() <= 1e-6) return std::nullopt;
    const double focal_px = 0.5 * viewport.height_px / std::tan(0.5 * camera.fov_y_rad);
    return Eigen::Vector2d(0.5 * viewport.width_px + focal_px * p.x() / p.z(),
                           0.5 * viewport.height_px + focal_px * p.y() / p.z());
}

Eigen::Vector3d unproject(const OrbitCamera& camera, const Viewport& viewport,
                          const Eigen::Vector2d& px, double depth_m) {
    const double focal_px = 0.5 * viewport.height_px / std::tan(0.5 * camera.fov_y_rad);
    const Eigen::Vector3d in_view((px.x() - 0.5 * viewport.width_px) / focal_px * depth_m,
                                  (px.y() - 0.5 * viewport.height_px) / focal_px * depth_m,
                                  depth_m);
    return camera.T_view_world().inverse() * in_view;
}

}  // namespace gripscan::ui
