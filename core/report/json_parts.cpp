#include "core/report/json_parts.h"

#include <algorithm>
#include <cmath>

#include "core/report/file_units.h"

namespace gripscan {
namespace {

std::string compact(const Json& json) {
    return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

bool has_lines(const Json& json) {
    return json.is_array() && std::any_of(json.begin(), json.end(),
                                          [](const Json& item) { return !item.is_number(); });
}

std::string list_text(const Json& json) {
    std::string text = "[";
    for (std::size_t i = 0; i < json.size(); ++i) {
        text += (i == 0 ? "\n  " : ",\n  ") + compact(json[i]);
    }
    return text + "]";
}

}  // namespace

Json json_number(const std::optional<double>& value) {
    if (!value || !std::isfinite(*value)) return nullptr;
    return *value;
}

Json json_deg(const std::optional<double>& rad) {
    if (!rad || !std::isfinite(*rad)) return nullptr;
    return file_deg(*rad);
}

Json json_mm(const std::optional<double>& metres) {
    if (!metres || !std::isfinite(*metres)) return nullptr;
    return file_mm(*metres);
}

Json json_vector(const Eigen::Vector3d& v) {
    return Json::array({v.x(), v.y(), v.z()});
}

Json json_pose(const std::optional<Pose>& T) {
    if (!T || !T->matrix().allFinite()) return nullptr;
    return row_major_from_pose(*T);
}

Json json_limits(const TurnLimits& limits) {
    return {{"angle_deg", file_deg(limits.angle_rad)},
            {"sigmas", limits.sigmas},
            {"overlap", limits.overlap},
            {"slip_mm", file_mm(limits.slip_m)},
            {"tilt_deg", file_deg(limits.tilt_rad)}};
}

Json json_closure(const TurnReport& report) {
    if (!report.closure_before || !report.closure_after) return nullptr;
    const auto one = [](const Closure& closure) -> Json {
        return {{"deg", json_deg(closure.angle_rad)}, {"mm", json_mm(closure.shift_m)}};
    };
    return {{"before", one(*report.closure_before)}, {"after", one(*report.closure_after)}};
}

void put_euler(Json& json, const std::optional<Pose>& T) {
    std::optional<EulerAngles> angles;
    if (T) angles = euler_from_rotation(T->linear());
    const auto angle = [&](double EulerAngles::*member) -> Json {
        return angles ? json_deg((*angles).*member) : Json(nullptr);
    };
    const auto shift = [&](int axis) -> Json {
        return T ? json_number(T->translation()[axis]) : Json(nullptr);
    };
    json["roll_deg"] = angle(&EulerAngles::roll_rad);
    json["pitch_deg"] = angle(&EulerAngles::pitch_rad);
    json["yaw_deg"] = angle(&EulerAngles::yaw_rad);
    json["x_m"] = shift(0);
    json["y_m"] = shift(1);
    json["z_m"] = shift(2);
}

std::string document_text(const Json& json) {
    std::string text = "{";
    for (const auto& [key, value] : json.items()) {
        text += text.size() == 1 ? "\n " : ",\n ";
        text += compact(key) + ": " + (has_lines(value) ? list_text(value) : compact(value));
    }
    return text + "\n}\n";
}

}  // namespace gripscan
