#include "core/report/stereo_json.h"

#include "core/report/json_parts.h"

namespace gripscan {

std::string stereo_json(const StereoCloud& stereo, const std::string& cloud_path,
                        const std::string& disparity_path) {
    const StereoHealth& health = stereo.health;
    Json json{{"format", "gripscan-stereo/1"}};
    json["cloud"] = {{"path", cloud_path}, {"points", stereo.cloud.size()}};
    json["disparity"] = disparity_path.empty() ? Json(nullptr) : Json(disparity_path);
    json["health"] = {{"fill", json_number(health.fill)},
                      {"mean_intensity", json_number(health.mean_intensity)},
                      {"saturated", json_number(health.saturated)},
                      {"texture", json_number(health.texture)},
                      {"row_error_px", json_number(health.row_error_px)}};
    return document_text(json);
}

}  // namespace gripscan
