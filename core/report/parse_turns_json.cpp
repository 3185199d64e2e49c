#include "core/base/units.h"
#include "core/report/json_parts.h"
#include "core/report/turns_json.h"

namespace gripscan {
namespace {

std::optional<double> number(const Json& json, const char* key, double scale = 1.0) {
    if (!json.contains(key) || json[key].is_null()) return std::nullopt;
    return json.at(key).get<double>() * scale;
}

std::optional<double> angle(const Json& json, const char* key) {
    return number(json, key, kRadPerDeg);
}

std::optional<double> length(const Json& json, const char* key) {
    return number(json, key, 1.0 / kMmPerM);
}

std::optional<Pose> pose(const Json& json) {
    if (json.is_null()) return std::nullopt;
    const auto numbers = json.get<std::array<double, 16>>();
    if (!pose_from_row_major(numbers)) {
        throw Json::other_error::create(501, "a matrix is no rigid motion", nullptr);
    }
    // The numbers as they stand: making them orthonormal again would change the last digits.
    Pose T;
    T.matrix() = Eigen::Map<const Eigen::Matrix<double, 4, 4, Eigen::RowMajor>>(numbers.data());
    return T;
}

Eigen::Vector3d vector3(const Json& json) {
    const auto v = json.get<std::array<double, 3>>();
    return {v[0], v[1], v[2]};
}

/// The value whose word this is.
template <typename Enum>
Enum from_word(const Json& json, int count) {
    const auto text = json.get<std::string>();
    for (int i = 0; i < count; ++i) {
        if (word(static_cast<Enum>(i)) == text) return static_cast<Enum>(i);
    }
    throw Json::other_error::create(501, "unknown word '" + text + "'", nullptr);
}

std::optional<GripSlip> grip_slip_of(const Json& json) {
    if (!length(json, "grip_slip_mm")) return std::nullopt;
    return GripSlip{length(json, "grip_slip_mm").value_or(0.0),
                    angle(json, "grip_slip_deg").value_or(0.0),
                    length(json, "grip_slip_sigma_mm").value_or(0.0),
                    angle(json, "grip_slip_sigma_deg").value_or(0.0)};
}

TurnStep step_of(const Json& json) {
    TurnStep step;
    step.index = json.at("index").get<int>();
    step.from = json.at("from").get<int>();
    step.to = json.at("to").get<int>();
    step.attempts = json.at("attempts").get<int>();
    step.commanded_rad = angle(json, "commanded_deg");
    step.robot_rad = angle(json, "robot_deg");
    step.icp_rad = angle(json, "icp_deg");
    step.error_rad = angle(json, "error_deg");
    step.sigma_rad = angle(json, "sigma_deg");
    step.observability = number(json, "observability");
    step.mode = from_word<TurnMode>(json.at("mode"), 3);
    step.independent = json.at("independent").get<bool>();
    step.tilt_rad = angle(json, "tilt_deg");
    step.axis_offset_m = length(json, "axis_offset_mm");
    step.slip_m = length(json, "slip_mm");
    step.T = pose(json.at("T"));
    step.overlap = number(json, "overlap");
    step.rms_m = length(json, "rms_mm");
    step.median_m = length(json, "median_mm");
    step.p90_m = length(json, "p90_mm");
    step.verdict = from_word<Verdict>(json.at("verdict"), 4);
    step.cause = from_word<Cause>(json.at("cause"), 17);
    step.sentence = json.value("sentence", "");
    step.grip_slip = grip_slip_of(json);
    return step;
}

TurnLimits limits_of(const Json& json) {
    TurnLimits limits;
    limits.angle_rad = angle(json, "angle_deg").value_or(limits.angle_rad);
    limits.sigmas = number(json, "sigmas").value_or(limits.sigmas);
    limits.overlap = number(json, "overlap").value_or(limits.overlap);
    limits.slip_m = length(json, "slip_mm").value_or(limits.slip_m);
    limits.tilt_rad = angle(json, "tilt_deg").value_or(limits.tilt_rad);
    return limits;
}

AxisEstimate axis_of(const Json& json) {
    AxisEstimate axis;
    axis.axis.point_m = vector3(json.at("point_m"));
    axis.axis.direction = vector3(json.at("direction"));
    axis.sd_rad = angle(json, "sd_deg").value_or(0.0);
    axis.sd_m = length(json, "sd_mm").value_or(0.0);
    return axis;
}

Closure closure_of(const Json& json) {
    return {angle(json, "deg").value_or(0.0), length(json, "mm").value_or(0.0)};
}

TurnsDocument document_of(const Json& json) {
    TurnsDocument document;
    TurnReport& report = document.report;
    report.sign_source = from_word<SignSource>(json.at("sign_source"), 3);
    report.limits = limits_of(json.at("limits"));
    for (const auto& step : json.at("steps")) report.steps.push_back(step_of(step));
    if (!json.at("axis").is_null()) report.axis = axis_of(json["axis"]);
    if (!json.at("closure").is_null()) {
        report.closure_before = closure_of(json["closure"].at("before"));
        report.closure_after = closure_of(json["closure"].at("after"));
    }
    for (const auto& one : json.at("poses")) report.poses.push_back(pose(one));
    report.angle_scale = number(json, "angle_scale");
    document.merged.path = json.at("template").at("path").get<std::string>();
    document.merged.points = json.at("template").at("points").get<std::size_t>();
    return document;
}

}  // namespace

Result<TurnsDocument> parse_turns_json(const std::filesystem::path& path, const std::string& text) {
    const Json json = Json::parse(text, nullptr, false);
    if (!json.is_object()) return input_error("{}: not a JSON document", path.string());
    const auto format = json.value("format", Json(""));
    if (format != "gripscan-turns/1") {
        return input_error("{}: format is {}; this version reads \"gripscan-turns/1\"",
                           path.string(), format.dump());
    }
    try {
        return document_of(json);
    } catch (const Json::exception& e) {
        return input_error("{}: not as expected: {}", path.string(), e.what());
    }
}

}  // namespace gripscan
