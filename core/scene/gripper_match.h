// The gripper's template found in a view: started from where the robot says it stands, settled and
// verified by the surfaces.
#pragma once

#include <optional>
#include <string>

#include "core/registration/surface.h"
#include "core/scene/gripper_template.h"

namespace gripscan {

struct GripperMatch {
    Pose T_camera_gripper = Pose::Identity();  ///< from the template's frame
    bool trusted = false;                      ///< verified by the surfaces
    /// They verify no pose and do not speak against the robot's: it is the robot's, unverified.
    bool as_robot_says = false;
    double matched = 0.0;        ///< share of the template that faces the camera and was found
    double hidden = 0.0;         ///< share of it behind what the camera saw: the object covers it
    double contradicted = 0.0;   ///< share of it where the camera looked through
    double rms_m = 0.0;          ///< of the matched points, along the normal
    double observability = 0.0;  ///< of the turn about the joint's axis; 0: its shape is round
    /// Where it was found against where the robot says: a witness of the robot and of the cell.
    double beside_rad = 0.0;
    double beside_m = 0.0;  ///< of the template's middle
    bool searched = false;  ///< where the robot has it is not known
    std::string sentence;

    [[nodiscard]] bool usable() const { return trusted || as_robot_says; }
};

/// `T_start`: where the gripper should stand; what is found beside it is believed only near by.
/// Nothing: its turn about the axis is searched. The scene needs a viewpoint to tell what speaks
/// against a pose.
[[nodiscard]] GripperMatch match_gripper(const GripperTemplate& gripper, const Surface& scene,
                                         const std::optional<Pose>& T_start);

/// Once more from where it was found, on its own points alone (`own`), so that what it holds does
/// not pull at it. `scene` is the whole view, as before.
[[nodiscard]] GripperMatch match_again(const GripperTemplate& gripper, const Surface& own,
                                       const Surface& scene, const std::optional<Pose>& T_start,
                                       const GripperMatch& before);

/// Where the gripper should stand with joint 6 at this angle; nothing where one of the two angles
/// is not known.
[[nodiscard]] std::optional<Pose> expected_pose(const GripperTemplate& gripper,
                                                std::optional<double> joint6_rad);

}  // namespace gripscan
