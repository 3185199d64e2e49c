#include "core/report/alignment_json.h"

#include "core/report/json_parts.h"

namespace gripscan {

std::string alignment_json(const Alignment& alignment, const std::optional<double>& rotation_rad) {
    const auto known = [&](double value) -> std::optional<double> {
        return alignment.found ? std::optional(value) : std::nullopt;
    };
    std::optional<Pose> T;
    if (alignment.found) T = alignment.T_target_source;
    std::optional<double> error_rad = known(alignment.angle_rad);
    if (rotation_rad && error_rad) *error_rad -= std::abs(*rotation_rad);

    Json json{{"format", "gripscan-align/1"}};
    json["T"] = json_pose(T);
    json["angle_deg"] = json_deg(known(alignment.angle_rad));
    json["axis"] = alignment.found ? json_vector(alignment.axis) : Json(nullptr);
    put_euler(json, T);
    json["overlap"] = json_number(known(alignment.overlap));
    json["rms_mm"] = json_mm(known(alignment.rms_m));
    // The paper's method predicts no uncertainty.
    const bool predicted = alignment.found && alignment.sigma_angle_rad > 0.0;
    json["sigma_deg"] = predicted ? json_deg(alignment.sigma_angle_rad) : Json(nullptr);
    json["observability"] = predicted ? json_number(alignment.observability) : Json(nullptr);
    json["starts_agree"] = alignment.starts_agree;
    json["verdict"] = word(alignment.verdict);
    json["cause"] = word(alignment.cause);
    json["rotation_deg"] = json_deg(rotation_rad);
    json["error_deg"] = rotation_rad ? json_deg(error_rad) : Json(nullptr);
    json["sentence"] = alignment.sentence;
    return document_text(json);
}

}  // namespace gripscan
