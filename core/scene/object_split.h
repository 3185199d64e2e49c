// The differentiating step of the paper: the gripper is matched into a view and enclosed in its
// cuboid, what lies inside is taken away, and the rest is the object.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "core/scene/gripper_match.h"

namespace gripscan {

enum class TrimBy {
    kAuto,     ///< by the cuboid, unless that takes too much of the object
    kCuboid,   ///< everything inside the gripper's cuboid, as published
    kSurface,  ///< what lies on the template's surface, to the noise of stereo
};
[[nodiscard]] std::string_view word(TrimBy trim);

struct ObjectSplitSettings {
    TrimBy trim = TrimBy::kAuto;
    /// Of the gripper's cuboid, face by face, along its own axes (z is the joint's axis).
    FaceMargins margins{Eigen::Vector3d::Constant(0.003), Eigen::Vector3d::Constant(0.003)};
    double most_lost = 0.02;  ///< share of the object that the cuboid may take
    /// A point is the gripper's within this of the template's surface and three times its own noise
    double surface_margin_m = 0.0008;
    double surface_reach_m = 0.003;  ///< and within this of a template point, beside it
    double least_piece_m2 = 60e-6;   ///< smaller pieces of surface are chance
};

/// What a view shows, taken apart. Clouds keep the grid of the view, so that they can be registered
/// as it can.
struct ObjectSplit {
    GripperMatch gripper;
    OrientedCuboid gripper_cuboid;  ///< camera frame, with margins
    std::optional<OrientedCuboid> object_cuboid;
    Cloud object;
    Cloud gripper_part;
    TrimBy trimmed_by = TrimBy::kCuboid;  ///< never kAuto
    /// Points inside the gripper's cuboid that are not on its surface: lost, if trimmed by the
    /// cuboid.
    std::size_t reaching_in = 0;
    std::size_t scattered = 0;  ///< points of pieces too small to be surface: in neither cloud
    std::string sentence;       ///< what was done, in numbers
};

/// `scene`: a view cut to the registration area, with normals and sigma. `T_start`: where the
/// gripper should stand, see expected_pose(). A gripper that was not found is no error: its match
/// says so and all points are left to the gripper. Errors: a scene too poor to register.
[[nodiscard]] Result<ObjectSplit> split_object(const GripperTemplate& gripper, const Cloud& scene,
                                               const std::optional<Pose>& T_start,
                                               const ObjectSplitSettings& settings);

}  // namespace gripscan
