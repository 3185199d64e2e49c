#include "core/recognition/library_add.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <nlohmann/json.hpp>

#include "core/base/atomic_file.h"
#include "core/base/checksum.h"
#include "core/base/units.h"
#include "core/cloud/cloud_file.h"
#include "core/geometry/axis_frame.h"
#include "core/recognition/shape_match.h"
#include "core/recognition/template_model.h"

namespace gripscan {
namespace fs = std::filesystem;
namespace {

using Json = nlohmann::json;

/// Two templates whose surfaces lie on each other to this share are of one shape.
constexpr double kSameShape = 0.95;
/// And their diagonals differ by no more than this share.
constexpr double kSameSize = 0.06;

bool is_mesh(const fs::path& path) {
    std::string end = path.extension().string();
    std::transform(end.begin(), end.end(), end.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return end == ".stl" || end == ".obj";
}

/// The template of a session or a results folder; the file itself otherwise.
Result<fs::path> points_of(const fs::path& source) {
    std::error_code code;
    if (!fs::exists(source, code)) return input_error("{} does not exist", source.string());
    if (!fs::is_directory(source, code)) return source;
    for (const fs::path& file : {source / "results" / "template.pcd", source / "template.pcd"}) {
        if (fs::exists(file, code)) return file;
    }
    return input_error(
        "{} holds no template.pcd, nor does its folder results; compute the session "
        "first",
        source.string());
}

Json json_beside(const fs::path& file) {
    std::error_code code;
    if (!fs::exists(file, code)) return nullptr;
    const auto text = read_whole_file(file);
    return text ? Json::parse(*text, nullptr, false) : Json(nullptr);
}

std::optional<Axis> axis_of(const Json& json) {
    if (!json.is_object() || !json.contains("axis") || !json["axis"].is_object()) {
        return std::nullopt;
    }
    const auto p = json["axis"].at("point_m").get<std::array<double, 3>>();
    const auto d = json["axis"].at("direction").get<std::array<double, 3>>();
    return Axis{{p[0], p[1], p[2]}, Eigen::Vector3d(d[0], d[1], d[2]).normalized()};
}

std::optional<std::string> rig_check(const Json& origin) {
    if (!origin.contains("sources")) return std::nullopt;
    for (const Json& one : origin["sources"]) {
        if (one.value("file", "") == "rig.yaml") return one.value("check", "");
    }
    return std::nullopt;
}

/// Which gripper held it, by the check sum of its template.
std::optional<HeldBy> held_by(const Library& library, const Json& origin) {
    if (!origin.contains("gripper") || !origin["gripper"].is_object()) return std::nullopt;
    const Json& gripper = origin["gripper"];
    HeldBy held;
    held.check = gripper.value("check", "");
    for (const LibraryEntry& e : library.entries) {
        if (e.check == held.check) held.gripper = e.name;
    }
    if (gripper.contains("T_gripper_object") && gripper["T_gripper_object"].is_array()) {
        held.T_gripper_object =
            pose_from_row_major(gripper["T_gripper_object"].get<std::array<double, 16>>());
    }
    return held;
}

/// What template.json and turns.json beside the points tell.
void take_history(const Library& library, const fs::path& points, const Cloud& cloud,
                  LibraryEntry& entry) {
    const Json origin = json_beside(fs::path(points).replace_extension(".json"));
    if (!origin.is_object() || origin.value("format", "") != "gripscan-template/1") return;
    entry.origin = origin.dump();
    if (entry.kind.empty()) entry.kind = origin.value("kind", "");
    entry.frame = origin.value("frame", entry.frame);
    if (origin.contains("settings") && origin["settings"].contains("step_deg") &&
        origin["settings"]["step_deg"].is_number()) {
        entry.alpha_deg = origin["settings"]["step_deg"].get<double>();
    }
    entry.calibration = rig_check(origin);
    entry.held = held_by(library, origin);
    auto axis = axis_of(origin);
    if (!axis) axis = axis_of(json_beside(points.parent_path() / "turns.json"));
    if (axis) entry.T_axis_template = T_axis_camera(*axis, centroid(cloud));
}

/// The bytes to keep: those of the file where it is a PCD in metres, so that check sums of others
/// stay true; else the points as a PCD.
Result<std::string> pcd_bytes(const fs::path& points, const AddRequest& request, const Cloud& cloud,
                              const fs::path& folder) {
    if (points.extension() == ".pcd" && request.metres_per_unit == 1.0) {
        return read_whole_file(points);
    }
    const fs::path scratch = folder / ".import.pcd";
    if (Status saved = save_cloud(scratch, cloud); !saved) return forward_error(saved.error());
    auto bytes = read_whole_file(scratch);
    std::error_code code;
    fs::remove(scratch, code);
    return bytes;
}

/// A CAD model's surface as far as a camera could see it from somewhere.
Cloud seen_from_outside(const Cloud& sampled, double spacing_m, const ForEach& for_each) {
    const OrientedPoints outside =
        outside_of({sampled.points, sampled.normals}, true, spacing_m, for_each);
    Cloud cloud;
    cloud.points = outside.points;
    cloud.normals = outside.normals;
    return cloud;
}

Result<Cloud> load_points(const fs::path& points, const AddRequest& request,
                          const ForEach& for_each) {
    CloudFileOptions options;
    options.metres_per_unit = request.metres_per_unit;
    options.mesh_spacing_m = request.mesh_spacing_m;
    auto cloud = load_cloud(points, options);
    if (!cloud || !is_mesh(points)) return cloud;
    return seen_from_outside(*cloud, request.mesh_spacing_m, for_each);
}

Box bounds_of(const Cloud& cloud) {
    Box box{cloud.points.front().cast<double>(), cloud.points.front().cast<double>()};
    for (const auto& p : cloud.points) {
        box.min_m = box.min_m.cwiseMin(p.cast<double>());
        box.max_m = box.max_m.cwiseMax(p.cast<double>());
    }
    return box;
}

bool same_shape(const TemplateModel& a, const TemplateModel& b, const ForEach& for_each) {
    // The longest distance, not the bounding box: that one changes when the part is turned.
    const double longest_a_m = a.pairs->longest_m();
    const double longest_b_m = b.pairs->longest_m();
    // Coarse points miss the very ends by up to a step, and a measured template lacks what no
    // camera saw.
    const double apart_m = kSameSize * std::max(longest_a_m, longest_b_m) + a.step_m;
    if (std::abs(longest_a_m - longest_b_m) > apart_m) return false;
    const ShapeMatcher onto_b(b);
    for (const ShapeMatch& m : onto_b.search(a, kSameShape, for_each)) {
        if (ShapeMatcher(a).same(b, m.T_still_moving.inverse()) >= kSameShape) return true;
    }
    return false;
}

Result<std::string> twin_of(const Library& library, const TemplateModel& model,
                            const std::string& name, const Progress& progress,
                            const ForEach& for_each) {
    for (const LibraryEntry& entry : library.entries) {
        if (entry.name == name) continue;
        if (progress.cancelled()) return cancelled_error();
        // Bounding boxes of one part, turned at will, have diagonals within a factor of √3.
        const double diagonal_m = (entry.bounds.max_m - entry.bounds.min_m).norm();
        const double smaller_m = std::min(diagonal_m, model.diameter_m);
        if (std::max(diagonal_m, model.diameter_m) > 1.8 * smaller_m) continue;
        const auto cloud = load_entry(library, entry);
        if (!cloud) return forward_error(cloud.error());
        const auto other = make_template_model(entry.name, *cloud, {}, progress, for_each);
        if (!other) return forward_error(other.error());
        if (same_shape(model, **other, for_each)) return entry.name;
    }
    return std::string();
}

std::string default_name(const fs::path& source, const fs::path& points) {
    if (source == points) return source.stem().string();
    fs::path folder = fs::absolute(source).lexically_normal();
    if (folder.filename().empty()) folder = folder.parent_path();
    if (folder.filename() == "results") folder = folder.parent_path();
    return folder.filename().string();
}

Status check_name(const Library& library, const LibraryEntry& entry, const std::string& check,
                  const AddRequest& request) {
    if (library.find(entry.name) != nullptr && !request.replace) {
        return input_error(
            "the library already has a template '{}'; choose another --name, or "
            "--replace it",
            entry.name);
    }
    if (request.allow_duplicate) return {};
    for (const LibraryEntry& e : library.entries) {
        if (e.name != entry.name && e.check == check) {
            return input_error(
                "the same points are already there as '{}'; --duplicate adds them "
                "all the same",
                e.name);
        }
    }
    return {};
}

}  // namespace

Result<Added> add_to_library(Library& library, const AddRequest& request, const Progress& progress,
                             const ForEach& for_each) {
    const auto points = points_of(request.source);
    if (!points) return forward_error(points.error());
    const auto cloud = load_points(*points, request, for_each);
    if (!cloud) return forward_error(cloud.error());
    LibraryEntry entry;
    entry.name = request.name.empty() ? default_name(request.source, *points) : request.name;
    entry.kind = request.kind;
    entry.frame = "as in " + points->filename().string();
    entry.source = fs::absolute(request.source).lexically_normal().string();
    entry.software = request.software;
    entry.points = cloud->size();
    entry.T_tool_template = request.T_tool_template;
    try {
        take_history(library, *points, *cloud, entry);
    } catch (const Json::exception& e) {
        return input_error("{}: {}", fs::path(*points).replace_extension(".json").string(),
                           e.what());
    }
    if (entry.kind.empty()) entry.kind = "object";
    std::error_code code;
    fs::create_directories(library.folder, code);
    const auto bytes = pcd_bytes(*points, request, *cloud, library.folder);
    if (!bytes) return forward_error(bytes.error());
    if (Status s = check_name(library, entry, checksum_text(*bytes), request); !s) {
        return forward_error(s.error());
    }
    const auto model = make_template_model(entry.name, *cloud, {}, progress, for_each);
    if (!model) return forward_error(model.error());
    entry.symmetry = (*model)->symmetry.name;
    entry.bounds = bounds_of(*cloud);
    const auto twin = twin_of(library, **model, entry.name, progress, for_each);
    if (!twin) return forward_error(twin.error());
    if (!twin->empty() && !request.allow_duplicate) {
        return input_error("'{}' has the same shape as '{}'; --duplicate adds it all the same",
                           entry.name, *twin);
    }
    if (Status s = store_entry(library, entry, *bytes); !s) return forward_error(s.error());
    return Added{*library.find(entry.name), *twin};
}

}  // namespace gripscan
