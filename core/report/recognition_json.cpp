#include "core/report/recognition_json.h"

#include "core/report/json_parts.h"

namespace gripscan {
namespace {

/// The terms of the score, as counts of cells of the view.
Json terms_json(const VisibleAgreement& a) {
    return {{"visible", a.visible},
            {"seen", a.seen},
            {"hidden", a.hidden},
            {"contradicted", a.contradicted},
            {"mismatched", a.mismatched},
            {"unknown", a.unknown},
            {"outline_ends", a.outline_ends},
            {"outline_open", a.outline_open},
            {"outline_bends", a.outline_bends},
            {"outline_goes_on", a.outline_goes_on},
            {"support", a.support()},
            {"found", a.found()},
            {"outline", a.outline()}};
}

Json joints_json(const JointAngles& joints_rad) {
    Json json = Json::array();
    for (const double angle : joints_rad) json.push_back(json_deg(angle));
    return json;
}

Json grasp_json(const std::optional<GraspPose>& grasp) {
    if (!grasp) return nullptr;
    const FanucPose f = fanuc_pose(grasp->T_robot_tool);
    return {{"T_robot_gripper", json_pose(grasp->T_robot_gripper)},
            {"T_robot_tool", json_pose(grasp->T_robot_tool)},
            {"x_mm", f.x_mm},
            {"y_mm", f.y_mm},
            {"z_mm", f.z_mm},
            {"w_deg", f.w_deg},
            {"p_deg", f.p_deg},
            {"r_deg", f.r_deg},
            {"reachable", grasp->reach.reachable},
            {"joints_deg",
             grasp->reach.reachable ? joints_json(grasp->reach.joints_rad) : Json(nullptr)},
            {"sentence", grasp->reach.sentence}};
}

Json detection_json(const PlacedDetection& placed) {
    const Detection& d = placed.detection;
    Json alternatives = Json::array();
    for (const AlternativePose& a : d.alternatives) {
        alternatives.push_back(
            {{"T_camera_template", json_pose(a.T_camera_template)}, {"score", a.score}});
    }
    Json json{{"template", d.name}};
    json["capture"] = placed.capture;
    json["T_camera_template"] = json_pose(d.T_camera_template);
    json["T_robot_template"] = json_pose(placed.T_robot_template);
    json["T_gripper_template"] = json_pose(placed.T_gripper_template);
    json["grasp"] = grasp_json(placed.grasp);
    json["score"] = json_number(d.score);
    json["inlier_fraction"] = json_number(d.agreement.found());
    json["rms_mm"] = json_mm(d.rms_m);
    json["symmetry"] = d.symmetry;
    json["alternatives"] = std::move(alternatives);
    json["terms"] = terms_json(d.agreement);
    json["explained"] = d.explained();
    return json;
}

}  // namespace

std::string recognition_json(const std::vector<PlacedDetection>& detections) {
    Json list = Json::array();
    for (const PlacedDetection& placed : detections) list.push_back(detection_json(placed));
    Json json{{"format", "gripscan-recognise/1"}};
    json["detections"] = std::move(list);
    return document_text(json);
}

}  // namespace gripscan
