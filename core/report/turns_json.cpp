#include "core/report/turns_json.h"

#include "core/base/units.h"
#include "core/report/json_parts.h"

namespace gripscan {
namespace {

Json step_json(const TurnStep& step) {
    Json json{
        {"index", step.index}, {"from", step.from}, {"to", step.to}, {"attempts", step.attempts}};
    json["commanded_deg"] = json_deg(step.commanded_rad);
    json["robot_deg"] = json_deg(step.robot_rad);
    json["icp_deg"] = json_deg(step.icp_rad);
    json["error_deg"] = json_deg(step.error_rad);
    json["sigma_deg"] = json_deg(step.sigma_rad);
    json["observability"] = json_number(step.observability);
    json["mode"] = word(step.mode);
    json["independent"] = step.independent;
    put_euler(json, step.T);
    json["tilt_deg"] = json_deg(step.tilt_rad);
    json["axis_offset_mm"] = json_mm(step.axis_offset_m);
    json["slip_mm"] = json_mm(step.slip_m);
    json["T"] = json_pose(step.T);
    json["overlap"] = json_number(step.overlap);
    json["rms_mm"] = json_mm(step.rms_m);
    json["verdict"] = word(step.verdict);
    json["cause"] = word(step.cause);
    json["median_mm"] = json_mm(step.median_m);
    json["p90_mm"] = json_mm(step.p90_m);
    json["sentence"] = step.sentence;
    if (step.grip_slip) {
        const GripSlip& slip = *step.grip_slip;
        json["grip_slip_mm"] = json_mm(slip.shift_m);
        json["grip_slip_deg"] = json_deg(slip.angle_rad);
        json["grip_slip_sigma_mm"] = json_mm(slip.sigma_shift_m);
        json["grip_slip_sigma_deg"] = json_deg(slip.sigma_angle_rad);
    }
    return json;
}

Json axis_json(const std::optional<AxisEstimate>& axis) {
    if (!axis) return nullptr;
    return {{"point_m", json_vector(axis->axis.point_m)},
            {"direction", json_vector(axis->axis.direction)},
            {"sd_deg", json_deg(axis->sd_rad)},
            {"sd_mm", json_mm(axis->sd_m)}};
}

}  // namespace

std::string turns_json(const TurnReport& report, const TemplateReference& merged) {
    Json json{{"format", "gripscan-turns/1"}};
    json["sign_source"] = word(report.sign_source);
    json["limits"] = json_limits(report.limits);
    json["steps"] = Json::array();
    for (const auto& step : report.steps) json["steps"].push_back(step_json(step));
    json["axis"] = axis_json(report.axis);
    json["closure"] = json_closure(report);
    json["poses"] = Json::array();
    for (const auto& pose : report.poses) json["poses"].push_back(json_pose(pose));
    json["template"] = {{"path", merged.path}, {"points", merged.points}};
    json["angle_scale"] = json_number(report.angle_scale);
    return document_text(json);
}

}  // namespace gripscan
