// Where everything stands in the simulated cell: the arm's pose, the camera and its lens, and the
// registration area that follows from them.
#pragma once

#include <cstdint>

#include "core/geometry/axis.h"
#include "core/geometry/box.h"
#include "core/geometry/stereo_rig.h"
#include "core/sim/scene_model.h"

namespace gripscan::sim {

struct CellLayout {
    JointAngles joints_rad{};  ///< at the start of a registration
    StereoRig rig;
    Eigen::Matrix3d R_camera_left = Eigen::Matrix3d::Identity();  ///< R1 of cv::stereoRectify
    Pose T_world_camera = Pose::Identity();  ///< the camera frame: left rectified
    std::uint64_t light_seed = 0;

    [[nodiscard]] Pose T_world_left() const;
    [[nodiscard]] Pose T_world_right() const;
};

/// The default stereo camera: 1280 × 960, f = 985 px, baseline 0.12 m; both lenses distort, and the
/// right camera is turned a little against the left one.
[[nodiscard]] StereoRig default_rig();

/// The same camera with `fraction` times fewer pixels a side.
[[nodiscard]] StereoRig shrunk(const StereoRig& rig, unsigned fraction);

/// A point on the axis of joint 6, this far out of the flange, lies 0.74 m before the camera.
inline constexpr double kGripperCentre_m = 0.085;
inline constexpr double kDistance_m = 0.74;

/// The seed turns the camera by up to 1.5° and shifts it by up to 15 mm.
[[nodiscard]] CellLayout make_layout(std::uint64_t seed);

/// Axis of joint 6 in the camera frame; its direction is that of a positive turn.
[[nodiscard]] Axis joint6_axis_in_camera(const CellLayout& layout);

/// Bounding box, in the camera frame, of everything that can turn with joint 6 and stands before
/// the flange, at every angle, plus 20 mm; on the arm's side it ends 20 mm before the parts that
/// do not turn.
[[nodiscard]] Box registration_area(const CellLayout& layout, const SceneModel& with_arm);

}  // namespace gripscan::sim
