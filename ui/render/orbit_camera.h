// The camera of the 3D view as pure maths: every gesture is a function from a camera to a camera.
// World and view frames: x right, y down, z forward, in m. Pixels: x right, y down, from the upper
// left corner of the view.
#pragma once

#include <Eigen/Core>
#include <optional>

#include "core/geometry/axis.h"
#include "core/geometry/box.h"
#include "core/geometry/pose.h"

namespace gripscan::ui {

struct Viewport {
    double width_px = 1.0;
    double height_px = 1.0;
};

/// Looks at `pivot_m` from a distance. Never rolls: the horizon of `R_world_home` stays level.
struct OrbitCamera {
    Eigen::Vector3d pivot_m = Eigen::Vector3d::Zero();
    double distance_m = 1.0;
    double yaw_rad = 0.0;    ///< positive: looks to the right
    double pitch_rad = 0.0;  ///< positive: looks down; −π/2 … π/2
    double fov_y_rad = 0.6;
    Eigen::Matrix3d R_world_home = Eigen::Matrix3d::Identity();  ///< the view at yaw = pitch = 0

    [[nodiscard]] Eigen::Matrix3d R_world_view() const;
    [[nodiscard]] Eigen::Vector3d eye_m() const;
    [[nodiscard]] Pose T_view_world() const;
    /// Pixels of one metre at the pivot.
    [[nodiscard]] double px_per_m(const Viewport& viewport) const;
};

/// Left drag: the front of the scene follows the mouse.
[[nodiscard]] OrbitCamera orbited(const OrbitCamera& camera, double dx_px, double dy_px,
                                  const Viewport& viewport);
/// Right or middle drag, or Shift and left: what lies at the pivot's depth follows the mouse.
[[nodiscard]] OrbitCamera panned(const OrbitCamera& camera, double dx_px, double dy_px,
                                 const Viewport& viewport);
/// Wheel: towards the point under the cursor (`anchor_m`, else what lies there at the pivot's
/// depth), which keeps its pixel. Goes on through the pivot, which then moves ahead.
[[nodiscard]] OrbitCamera zoomed(const OrbitCamera& camera, double clicks,
                                 const Eigen::Vector2d& cursor_px, const Viewport& viewport,
                                 const std::optional<Eigen::Vector3d>& anchor_m = std::nullopt);
/// Double click: the point becomes the pivot and the middle; the picture keeps its size there.
[[nodiscard]] OrbitCamera with_pivot(const OrbitCamera& camera, const Eigen::Vector3d& point_m);
/// F, Home: the whole box in view, from the same side.
[[nodiscard]] OrbitCamera fitted(const OrbitCamera& camera, const Box& box,
                                 const Viewport& viewport);

enum class AxisView { kFront, kSide, kTop };
/// Ctrl+1, 3, 7.
[[nodiscard]] OrbitCamera axis_view(const OrbitCamera& camera, AxisView view);
/// A: along the direction of the axis, the pivot on it.
[[nodiscard]] OrbitCamera looking_along(const OrbitCamera& camera, const Axis& axis);
/// V: from where the left camera stands (the world's origin), along its z.
[[nodiscard]] OrbitCamera from_stereo_camera(const OrbitCamera& camera, double depth_m);

/// What is drawn, in front of the eye.
struct ClipRange {
    double near_m = 0.01;
    double far_m = 10.0;
};
/// Just around a ball (centre, radius), never less than a ratio that depth can resolve.
[[nodiscard]] ClipRange clip_range(const OrbitCamera& camera, const Eigen::Vector3d& centre_m,
                                   double radius_m);

/// OpenGL's clip coordinates from world points (column vectors).
[[nodiscard]] Eigen::Matrix4d clip_from_world(const OrbitCamera& camera, const Viewport& viewport,
                                              const ClipRange& range);

/// Pixel of a point; nothing behind the eye.
[[nodiscard]] std::optional<Eigen::Vector2d> project(const OrbitCamera& camera,
                                                     const Viewport& viewport,
                                                     const Eigen::Vector3d& point_m);
/// The point seen at a pixel, `depth_m` along the view's z.
[[nodiscard]] Eigen::Vector3d unproject(const OrbitCamera& camera, const Viewport& viewport,
                                        const Eigen::Vector2d& px, double depth_m);

}  // namespace gripscan::ui
