#include "core/sim/truth.h"

#include <nlohmann/json.hpp>

#include "core/base/atomic_file.h"
#include "core/base/units.h"
#include "core/sim/mesh_file.h"
#include "core/sim/visibility.h"

namespace gripscan::sim {
namespace {

using nlohmann::ordered_json;

constexpr double kSpacing_m = 0.0009;

ordered_json json_of(const Eigen::Vector3d& v) {
    return {v.x(), v.y(), v.z()};
}

ordered_json json_of(const Eigen::Matrix3d& M) {
    ordered_json numbers = ordered_json::array();
    for (int i = 0; i < 9; ++i) numbers.push_back(M(i / 3, i % 3));
    return numbers;
}

ordered_json json_of(const StereoRig& rig) {
    return {{"image_width", rig.image.width},
            {"image_height", rig.image.height},
            {"K1", json_of(rig.K_left)},
            {"D1", rig.D_left},
            {"K2", json_of(rig.K_right)},
            {"D2", rig.D_right},
            {"R", json_of(Eigen::Matrix3d(rig.T_right_left.linear()))},
            {"T", json_of(Eigen::Vector3d(rig.T_right_left.translation()))}};
}

ordered_json json_of_capture(const TruthSource& truth, int capture, const Moment& moment) {
    ordered_json joints_deg = ordered_json::array();
    for (const double angle : moment.true_rad) joints_deg.push_back(deg_from_rad(angle));
    return {{"index", capture},
            {"joints_deg", joints_deg},
            {"T_first_k", row_major_from_pose(pose_to_first(truth, capture))},
            {"T_camera_object", row_major_from_pose(T_camera_object(truth.layout, moment))},
            {"T_camera_tool", row_major_from_pose(T_camera_part(truth.layout, moment))},
            {"T_world_camera", row_major_from_pose(T_world_camera(truth.layout, moment))},
            {"intruder", moment.intruder},
            {"tool", moment.tool},
            {"surroundings_shift_m", json_of(moment.surroundings_shift_m)},
            {"defocus_px", moment.defocus_px},
            {"glare_px", moment.glare_px}};
}

ordered_json json_of(const TruthSource& truth) {
    const Axis axis = joint6_axis_in_camera(truth.layout);
    ordered_json captures = ordered_json::array();
    for (const auto& [capture, moment] : truth.captures) {
        captures.push_back(json_of_capture(truth, capture, moment));
    }
    return {
        {"format", "gripscan-truth/1"},
        {"axis", {{"point_m", json_of(axis.point_m)}, {"direction", json_of(axis.direction)}}},
        {"region", {{"min", json_of(truth.region.min_m)}, {"max", json_of(truth.region.max_m)}}},
        {"T_world_camera", row_major_from_pose(truth.layout.T_world_camera)},
        {"rig", json_of(truth.layout.rig)},
        {"captures", captures}};
}

Mesh mesh_of(const Body& body) {
    Mesh mesh;
    for (const Part& part : body.parts) append(mesh, part.mesh);
    return mesh;
}

/// What a scan of some bodies could find at best, in the camera frame of the first capture.
struct IdealScan {
    Mesh surface;
    std::vector<SurfaceSample> visible;
};

void scan(const TruthSource& truth, std::size_t body, VisibilityTest& visibility,
          const ForEach& for_each, IdealScan& result) {
    const Moment& first = truth.captures.begin()->second;
    const Mesh mesh = mesh_of(truth.model.bodies[body]);
    const Pose T_camera_body =
        T_world_camera(truth.layout, first).inverse() * body_poses(first)[body];
    append(result.surface, mesh, T_camera_body);
    const auto samples = sample_surface(mesh, kSpacing_m);
    std::vector<char> seen(samples.size(), 0);
    for (const auto& [capture, moment] : truth.captures) {
        visibility.mark(moment, body, samples, seen, for_each);
    }
    for (std::size_t i = 0; i < samples.size(); ++i) {
        if (seen[i] == 0) continue;
        result.visible.push_back(
            {T_camera_body * samples[i].point_m, T_camera_body.linear() * samples[i].normal});
    }
}

Status save(const IdealScan& scan, const std::filesystem::path& folder, const std::string& prefix) {
    if (Status ok = save_mesh_ply(folder / (prefix + "surface.ply"), scan.surface); !ok) return ok;
    return save_samples_ply(folder / (prefix + "visible.ply"), scan.visible);
}

}  // namespace

Pose pose_to_first(const TruthSource& truth, int capture) {
    return T_camera_part(truth.layout, truth.captures.begin()->second) *
           T_camera_part(truth.layout, truth.captures.at(capture)).inverse();
}

Status write_truth_files(const TruthSource& truth, const std::filesystem::path& folder,
                         const ForEach& for_each) {
    if (truth.captures.empty()) {
        return input_error("no truth to write to {}: no capture has been grabbed", folder.string());
    }
    auto scene = RayScene::create(truth.model);
    if (!scene) return forward_error(scene.error());
    VisibilityTest visibility(truth.layout, truth.region, std::move(*scene));

    IdealScan whole;
    for (const std::size_t body : {SceneModel::kFlange, SceneModel::kTool, SceneModel::kObject}) {
        scan(truth, body, visibility, for_each, whole);
    }
    std::error_code failure;
    std::filesystem::create_directories(folder, failure);
    if (failure) {
        return input_error("cannot make the folder {}: {}", folder.string(), failure.message());
    }
    if (Status ok = save(whole, folder, ""); !ok) return ok;
    if (!truth.model.bodies[SceneModel::kObject].parts.empty()) {
        IdealScan object;
        scan(truth, SceneModel::kObject, visibility, for_each, object);
        if (Status ok = save(object, folder, "object_"); !ok) return ok;
    }
    return write_file_atomically(folder / "truth.json", json_of(truth).dump(1) + "\n");
}

}  // namespace gripscan::sim
