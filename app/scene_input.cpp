#include "app/scene_input.h"

#include <algorithm>
#include <filesystem>

#include "app/number_checks.h"
#include "core/cloud/cloud_file.h"
#include "core/procedure/turn_workspace.h"
#include "core/session/capture_joints.h"
#include "core/session/session.h"
#include "core/stereo/depth_cloud.h"

namespace gripscan::app {
namespace fs = std::filesystem;
namespace {

Result<Cloud> load_file(const SceneOptions& options) {
    if (options.intrinsics.empty()) return load_cloud(options.scene);
    return load_depth_cloud(options.scene,
                            {options.intrinsics[0], options.intrinsics[1], options.intrinsics[2],
                             options.intrinsics[3], options.depth_scale.value_or(1000.0)});
}

Result<std::vector<InputView>> load_session(const SceneOptions& options, const Progress& progress,
                                            const ForEach& for_each) {
    const auto session = open_session(options.scene);
    if (!session) return forward_error(session.error());
    const TurnRecording recording = recording_of(*session);
    const auto workspace =
        TurnWorkspace::create(recording.rig, recording.region, compute_settings_of(*session));
    if (!workspace) return forward_error(workspace.error());
    std::vector<InputView> views;
    for (std::size_t i = 0; i < recording.captures.size(); ++i) {
        const RecordedCapture& capture = recording.captures[i];
        if (options.capture ? capture.index != *options.capture : !capture.used) continue;
        auto prepared = workspace->prepare(capture, progress, for_each);
        if (!prepared) return forward_error(prepared.error());
        views.push_back(
            {capture.index, std::move(prepared->view.cloud), joints_rad(session->table.rows[i])});
    }
    if (views.empty() && options.capture) {
        return input_error("{} has no capture {}", options.scene, *options.capture);
    }
    if (views.empty()) return input_error("{} has no capture in use", options.scene);
    return views;
}

}  // namespace

void add_scene_options(CLI::App& command, SceneOptions& options) {
    command
        .add_option("--scene", options.scene,
                    "What the camera saw: a cloud, a session, or a depth image with --intrinsics")
        ->required()
        ->option_text("PCD|PLY|SESSION|DEPTH.png");
    command
        .add_option("--capture", options.capture, "Of a session: this capture only (all in use)")
        ->option_text("I");
    command
        .add_option("--intrinsics", options.intrinsics,
                    "Of a depth image: focal lengths and principal point, px")
        ->delimiter(',')
        ->expected(4)
        ->check(finite_number())
        ->option_text("fx,fy,cx,cy");
    command
        .add_option("--depth-scale", options.depth_scale,
                    "Of a depth image: values a metre has (1000)")
        ->check(finite_number())
        ->option_text("S");
    command
        .add_option("--viewpoint", options.viewpoint_m,
                    "Where the camera stood, m (a PCD's own, else the origin)")
        ->delimiter(',')
        ->expected(3)
        ->check(finite_number())
        ->option_text("x,y,z");
}

Result<std::vector<InputView>> load_scene(const SceneOptions& options, const Progress& progress,
                                          const ForEach& for_each) {
    std::vector<InputView> views;
    std::error_code code;
    if (fs::is_directory(options.scene, code)) {
        auto loaded = load_session(options, progress, for_each);
        if (!loaded) return forward_error(loaded.error());
        views = std::move(*loaded);
    } else {
        if (options.capture) {
            return input_error("--capture is for sessions; {} is a file", options.scene);
        }
        auto cloud = load_file(options);
        if (!cloud) return forward_error(cloud.error());
        views.push_back({0, std::move(*cloud), std::nullopt});
    }
    for (InputView& view : views) {
        if (options.viewpoint_m.empty()) continue;
        view.cloud.viewpoint =
            Eigen::Vector3d(options.viewpoint_m[0], options.viewpoint_m[1], options.viewpoint_m[2])
                .cast<float>();
        view.cloud.normals.clear();  // towards another viewpoint
    }
    return views;
}

}  // namespace gripscan::app
