// What was recognised, put into the cell: in the gripper's and the robot's frame, and how it is to
// be grasped. Shared by the command and the window.
#pragma once

#include "app/template_input.h"
#include "core/report/recognition_json.h"

namespace gripscan::app {

/// What is known of the robot when a view was taken.
struct RobotThen {
    std::optional<Pose> T_robot_camera;
    std::optional<JointAngles> joints_rad;
};

[[nodiscard]] std::vector<PlacedDetection> placed_detections(
    const std::vector<LoadedTemplate>& templates, const std::vector<Detection>& found, int capture,
    const RobotThen& robot);

}  // namespace gripscan::app
