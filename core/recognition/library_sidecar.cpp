// Sidecars as JSON (gripscan-library/1).

#include <nlohmann/json.hpp>

#include "core/base/atomic_file.h"
#include "core/base/units.h"
#include "core/recognition/library.h"

namespace gripscan {
namespace fs = std::filesystem;
namespace {

using Json = nlohmann::ordered_json;
constexpr std::string_view kFormat = "gripscan-library/1";

Json pose_json(const std::optional<Pose>& T) {
    if (!T) return nullptr;
    return row_major_from_pose(*T);
}

template <typename T>
Json or_null(const std::optional<T>& value) {
    return value ? Json(*value) : Json(nullptr);
}

std::optional<Pose> read_pose(const Json& json) {
    if (!json.is_array()) return std::nullopt;
    return pose_from_row_major(json.get<std::array<double, 16>>());
}

template <typename T>
std::optional<T> read_optional(const Json& json, const char* key) {
    if (!json.contains(key) || json.at(key).is_null()) return std::nullopt;
    return json.at(key).get<T>();
}

Eigen::Vector3d read_vector(const Json& json) {
    const auto v = json.get<std::array<double, 3>>();
    return {v[0], v[1], v[2]};
}

Json vector_json(const Eigen::Vector3d& v) {
    return Json::array({v.x(), v.y(), v.z()});
}

Json held_json(const HeldBy& held) {
    return {{"gripper", held.gripper.empty() ? Json(nullptr) : Json(held.gripper)},
            {"check", held.check},
            {"T_gripper_object", pose_json(held.T_gripper_object)}};
}

LibraryEntry entry_from(const Json& json) {
    LibraryEntry e;
    e.name = json.at("name").get<std::string>();
    e.file = json.at("file").get<std::string>();
    e.check = json.at("check").get<std::string>();
    e.kind = json.at("kind").get<std::string>();
    e.unit = json.at("unit").get<std::string>();
    e.frame = json.at("frame").get<std::string>();
    e.T_axis_template = read_pose(json.at("T_axis_template"));
    e.T_tool_template = read_pose(json.at("T_tool_template"));
    e.alpha_deg = read_optional<double>(json, "alpha_deg");
    e.points = json.at("points").get<std::size_t>();
    e.bounds.min_m = read_vector(json.at("bounds_mm").at("min")) / kMmPerM;
    e.bounds.max_m = read_vector(json.at("bounds_mm").at("max")) / kMmPerM;
    e.symmetry = json.at("symmetry").get<std::string>();
    e.calibration = read_optional<std::string>(json, "calibration");
    e.source = json.at("source").get<std::string>();
    e.software = json.at("software").get<std::string>();
    if (const Json& held = json.at("held_by"); !held.is_null()) {
        e.held =
            HeldBy{read_optional<std::string>(held, "gripper").value_or(""),
                   held.at("check").get<std::string>(), read_pose(held.at("T_gripper_object"))};
    }
    if (const Json& origin = json.at("origin"); !origin.is_null()) e.origin = origin.dump();
    return e;
}

}  // namespace

std::string sidecar_text(const LibraryEntry& e) {
    Json json{{"format", kFormat}, {"name", e.name}, {"file", e.file}, {"check", e.check}};
    json["kind"] = e.kind;
    json["unit"] = e.unit;
    json["frame"] = e.frame;
    json["T_axis_template"] = pose_json(e.T_axis_template);
    json["T_tool_template"] = pose_json(e.T_tool_template);
    json["alpha_deg"] = or_null(e.alpha_deg);
    json["points"] = e.points;
    json["bounds_mm"] = {{"min", vector_json(kMmPerM * e.bounds.min_m)},
                         {"max", vector_json(kMmPerM * e.bounds.max_m)}};
    json["symmetry"] = e.symmetry;
    json["calibration"] = or_null(e.calibration);
    json["source"] = e.source;
    json["software"] = e.software;
    json["held_by"] = e.held ? held_json(*e.held) : Json(nullptr);
    json["origin"] = e.origin.empty() ? Json(nullptr) : Json::parse(e.origin, nullptr, false);
    return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

Result<LibraryEntry> parse_sidecar(const fs::path& path, const std::string& text) {
    const Json json = Json::parse(text, nullptr, false);
    if (json.is_discarded() || !json.is_object()) {
        return input_error("{} is no JSON object", path.string());
    }
    if (json.value("format", "") != kFormat) {
        return input_error("{} is not of the format {}", path.string(), kFormat);
    }
    try {
        LibraryEntry entry = entry_from(json);
        if (fs::path(entry.file).filename() != entry.file || entry.file.empty()) {
            return input_error("{}: 'file' must name a file in the library's folder",
                               path.string());
        }
        return entry;
    } catch (const Json::exception& e) {
        return input_error("{}: {}", path.string(), e.what());
    }
}

std::string sidecar_kind(const fs::path& sidecar) {
    const auto text = read_whole_file(sidecar);
    if (!text) return {};
    const Json json = Json::parse(*text, nullptr, false);
    if (!json.is_object() || !json.contains("kind") || !json.at("kind").is_string()) return {};
    return json.at("kind").get<std::string>();
}

}  // namespace gripscan
