#include "app/placed_detections.h"

namespace gripscan::app {
namespace {

/// The best detection of a gripper; of any gripper without a name.
const Detection* gripper_among(const std::vector<LoadedTemplate>& templates,
                               const std::vector<Detection>& found, const std::string& name) {
    for (const Detection& d : found) {
        const bool is_gripper = templates[d.template_index].kind == "gripper";
        if (is_gripper && (name.empty() || d.name == name)) return &d;
    }
    return nullptr;
}

/// Where the gripper's template sits on the flange: as the library says, else as seen here.
std::optional<Pose> T_tool_gripper(const std::vector<LoadedTemplate>& templates,
                                   const std::vector<Detection>& found, const std::string& name,
                                   const RobotThen& robot) {
    for (const LoadedTemplate& t : templates) {
        if (t.model->name == name && t.T_tool_template) return t.T_tool_template;
    }
    const Detection* seen = gripper_among(templates, found, name);
    if (seen == nullptr || !robot.joints_rad || name.empty()) return std::nullopt;
    return T_tool_template(*robot.T_robot_camera, *robot.joints_rad) * seen->T_camera_template;
}

std::optional<GraspPose> grasp_of(const std::vector<LoadedTemplate>& templates,
                                  const std::vector<Detection>& found, const Detection& d,
                                  const RobotThen& robot) {
    const LoadedTemplate& object = templates[d.template_index];
    if (!robot.T_robot_camera || !object.held || !object.held->T_gripper_object) {
        return std::nullopt;
    }
    const auto T_tool = T_tool_gripper(templates, found, object.held->gripper, robot);
    if (!T_tool) return std::nullopt;
    std::vector<Pose> same{*robot.T_robot_camera * d.T_camera_template};
    for (const Pose& turn : object.model->symmetry.turns) same.push_back(same.front() * turn);
    return best_grasp(same, {*object.held->T_gripper_object, *T_tool},
                      robot.joints_rad.value_or(JointAngles{}));
}

}  // namespace

std::vector<PlacedDetection> placed_detections(const std::vector<LoadedTemplate>& templates,
                                               const std::vector<Detection>& found, int capture,
                                               const RobotThen& robot) {
    const Detection* gripper = gripper_among(templates, found, "");
    std::vector<PlacedDetection> all;
    for (const Detection& d : found) {
        PlacedDetection p;
        p.capture = capture;
        if (robot.T_robot_camera) p.T_robot_template = *robot.T_robot_camera * d.T_camera_template;
        if (gripper != nullptr) {
            p.T_gripper_template = gripper->T_camera_template.inverse() * d.T_camera_template;
        }
        p.grasp = grasp_of(templates, found, d, robot);
        p.detection = d;
        all.push_back(std::move(p));
    }
    return all;
}

}  // namespace gripscan::app
