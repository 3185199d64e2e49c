#include "core/report/calibration_json.h"

#include "core/report/json_parts.h"

namespace gripscan {
namespace {

Json view_json(const CalibrationView& view) {
    Json json{{"left", view.left.string()}, {"right", view.right.string()}};
    json["corners"] = view.corners;
    json["used"] = view.used;
    const bool measured = view.corners > 0;
    json["rms_left_px"] = measured ? json_number(view.rms_left_px) : Json(nullptr);
    json["rms_right_px"] = measured ? json_number(view.rms_right_px) : Json(nullptr);
    json["problem"] = view.problem.empty() ? Json(nullptr) : Json(view.problem);
    return json;
}

}  // namespace

std::string calibration_json(const CalibrationResult& result, const std::string& rig_path) {
    const StereoRig& rig = result.rig;
    Json json{{"format", "gripscan-calibration/1"}};
    json["rig"] = rig_path.empty() ? Json(nullptr) : Json(rig_path);
    json["rejected"] = result.rejected;
    json["reason"] = result.reason.empty() ? Json(nullptr) : Json(result.reason);
    json["baseline_mm"] = json_mm(rig.baseline_m());
    json["f_left_px"] = Json::array({rig.K_left(0, 0), rig.K_left(1, 1)});
    json["f_right_px"] = Json::array({rig.K_right(0, 0), rig.K_right(1, 1)});
    json["distortion_model"] = result.distortion_model;
    json["rms_px"] = json_number(result.rms_px);
    json["row_rms_px"] = json_number(result.row_rms_px);
    json["row_max_px"] = json_number(result.row_max_px);
    json["length_mean_error_mm"] = json_mm(result.length_mean_error_m);
    json["length_sd_mm"] = json_mm(result.length_sd_m);
    json["views"] = Json::array();
    for (const auto& view : result.views) json["views"].push_back(view_json(view));
    return document_text(json);
}

}  // namespace gripscan
