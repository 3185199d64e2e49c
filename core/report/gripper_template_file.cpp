#include "core/report/gripper_template_file.h"

#include "core/base/atomic_file.h"
#include "core/base/checksum.h"
#include "core/base/units.h"
#include "core/cloud/cloud_file.h"
#include "core/report/json_parts.h"
#include "core/report/turns_json.h"

namespace gripscan {
namespace {
namespace fs = std::filesystem;

/// What the registration knew of the frame.
struct FrameFacts {
    std::optional<Axis> axis;
    std::optional<double> joint6_rad;
};

fs::path full_path(const fs::path& path) {
    std::error_code code;
    fs::path result = fs::absolute(path, code).lexically_normal();
    if (result.filename().empty()) result = result.parent_path();
    return result;
}

fs::path template_in(const fs::path& given) {
    std::error_code code;
    return fs::is_directory(given, code) ? given / "results" / "template.pcd" : given;
}

Eigen::Vector3d vector3(const Json& json) {
    const auto v = json.get<std::array<double, 3>>();
    return {v[0], v[1], v[2]};
}

Result<FrameFacts> read_sidecar(const fs::path& path) {
    FrameFacts facts;
    std::error_code code;
    if (!fs::exists(path, code)) return facts;
    const auto text = read_whole_file(path);
    if (!text) return forward_error(text.error());
    try {
        const Json json = Json::parse(*text);
        if (json.contains("axis") && !json["axis"].is_null()) {
            facts.axis =
                Axis{vector3(json["axis"].at("point_m")), vector3(json["axis"].at("direction"))};
        }
        if (json.contains("frame_joint6_deg") && !json["frame_joint6_deg"].is_null()) {
            facts.joint6_rad = rad_from_deg(json["frame_joint6_deg"].get<double>());
        }
    } catch (const Json::exception& e) {
        return input_error("{}: not as expected: {}", path.string(), e.what());
    }
    return facts;
}

Result<FrameFacts> facts_beside(const fs::path& cloud) {
    auto facts = read_sidecar(fs::path(cloud).replace_extension(".json"));
    if (!facts || facts->axis) return facts;
    std::error_code code;
    if (fs::exists(cloud.parent_path() / "turns.json", code)) {
        const auto text = read_whole_file(cloud.parent_path() / "turns.json");
        if (!text) return forward_error(text.error());
        const auto turns = parse_turns_json(cloud.parent_path() / "turns.json", *text);
        if (!turns) return forward_error(turns.error());
        if (turns->report.axis) facts->axis = turns->report.axis->axis;
    }
    if (facts->axis) return facts;
    return input_error(
        "{}: neither its sidecar {} nor turns.json beside it tells the axis that the gripper turns "
        "about; take the template from the results folder of its registration",
        cloud.string(), fs::path(cloud).replace_extension(".json").filename().string());
}

}  // namespace

Result<std::shared_ptr<const GripperTemplate>> load_gripper_template(const fs::path& folder,
                                                                     const std::string& named) {
    const fs::path path = template_in(full_path(folder / named));
    const auto bytes = read_whole_file(path);
    if (!bytes) return forward_error(bytes.error());
    auto cloud = load_cloud(path);
    if (!cloud) return forward_error(cloud.error());
    const auto facts = facts_beside(path);
    if (!facts) return forward_error(facts.error());
    auto made = make_gripper_template(std::move(*cloud), *facts->axis, facts->joint6_rad);
    if (!made) return input_error("{}: {}", path.string(), made.error().message);
    made->file = named;
    made->check = checksum_text(*bytes);
    return std::make_shared<const GripperTemplate>(std::move(*made));
}

std::string name_of_template(const fs::path& session, const fs::path& given) {
    const fs::path target = full_path(template_in(given));
    const fs::path beside = target.lexically_relative(full_path(session).parent_path());
    const bool together = !beside.empty() && *beside.begin() != "..";
    return together ? target.lexically_relative(full_path(session)).generic_string()
                    : target.generic_string();
}

}  // namespace gripscan
