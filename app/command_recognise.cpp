#include <fmt/format.h>

#include <filesystem>
#include <memory>

#include "app/commands.h"
#include "app/console.h"
#include "app/placed_detections.h"
#include "app/progress_bar.h"
#include "app/scene_input.h"
#include "app/template_input.h"
#include "app/threads.h"
#include "core/base/units.h"
#include "core/report/recognition_json.h"
#include "core/robot/kinematics.h"
#include "core/session/alignment_file.h"

namespace gripscan::app {
namespace {

struct RecogniseOptions {
    TemplateOptions templates;
    SceneOptions scene;
    std::string alignment;
};

std::string pose_text(const Pose& T) {
    const EulerAngles a = euler_from_rotation(T.linear());
    const Eigen::Vector3d t = kMmPerM * T.translation();
    return fmt::format("X {:.2f} Y {:.2f} Z {:.2f} mm, W {:.2f} P {:.2f} R {:.2f} deg", t.x(),
                       t.y(), t.z(), deg_from_rad(a.roll_rad), deg_from_rad(a.pitch_rad),
                       deg_from_rad(a.yaw_rad));
}

std::string detection_text(const PlacedDetection& p) {
    const Detection& d = p.detection;
    std::string text = fmt::format("{}  capture {}, score {:.2f}, rms {:.2f} mm, symmetry {}\n",
                                   d.name, p.capture, d.score, kMmPerM * d.rms_m, d.symmetry);
    text += fmt::format("  in the camera   {}\n", pose_text(d.T_camera_template));
    if (p.T_gripper_template) {
        text += fmt::format("  in the gripper  {}\n", pose_text(*p.T_gripper_template));
    }
    if (p.T_robot_template) {
        text += fmt::format("  in the robot    {}\n", pose_text(*p.T_robot_template));
    }
    if (p.grasp) {
        text += fmt::format("  to grasp it     {}; {}\n", pose_text(p.grasp->T_robot_tool),
                            p.grasp->reach.sentence);
    }
    text += fmt::format("  {}\n", d.explained());
    for (const AlternativePose& a : d.alternatives) {
        text += fmt::format("  or, with score {:.2f}, in the camera {}\n", a.score,
                            pose_text(a.T_camera_template));
    }
    return text;
}

Result<std::vector<PlacedDetection>> search(const RecogniseOptions& options,
                                            const Context& context) {
    std::optional<Pose> T_robot_camera;
    if (!options.alignment.empty()) {
        const auto loaded = load_robot_camera(options.alignment);
        if (!loaded) return forward_error(loaded.error());
        T_robot_camera = *loaded;
    }
    WorkerPool pool(thread_count(context));
    ProgressBar bar(context);
    const Progress progress = bar.progress();
    const auto templates = load_templates(options.templates, progress, pool.for_each());
    if (!templates) return forward_error(templates.error());
    const auto views = load_scene(options.scene, progress, pool.for_each());
    if (!views) return forward_error(views.error());
    std::vector<PlacedDetection> all;
    for (const InputView& view : *views) {
        auto found = recognise(models_of(*templates), view.cloud, {}, progress, pool.for_each());
        if (!found && found.error().kind == ErrorKind::kInput) {
            return input_error("{}, capture {}: {}", options.scene.scene, view.capture,
                               found.error().message);
        }
        if (!found) return forward_error(found.error());
        for (auto& p : placed_detections(*templates, *found, view.capture,
                                         {T_robot_camera, view.joints_rad})) {
            all.push_back(std::move(p));
        }
    }
    return all;
}

Result<ExitStatus> recognise_command(const RecogniseOptions& options, const Context& context) {
    const auto found = search(options, context);
    if (!found) return forward_error(found.error());
    if (context.options.json) {
        print_result(recognition_json(*found));
    } else if (!context.options.quiet) {
        if (found->empty()) print_result("none of the templates is in the scene\n");
        for (const PlacedDetection& p : *found) print_result(detection_text(p));
    }
    return kDone;
}

}  // namespace

void add_recognise(const CommandLine& line) {
    auto options = std::make_shared<RecogniseOptions>();
    CLI::App* command =
        line.app.add_subcommand("recognise", "Which templates are in a view, and at which pose");
    add_template_options(*command, options->templates);
    add_scene_options(*command, options->scene);
    command
        ->add_option("--alignment", options->alignment,
                     "T_robot_camera as `calibrate robot` writes it: poses in the "
                     "robot's frame too")
        ->option_text("FILE");
    add_common_options(*command, line.common);
    command->footer(
        "Examples:\n"
        "  gripscan recognise --library parts --scene monday --capture 3 --json\n"
        "  gripscan recognise --template box.pcd mug.pcd --scene depth.png\n"
        "      --intrinsics 1066.8,1067.5,313.0,241.3 --depth-scale 10000\n"
        "\n"
        "Exit status 0: the search was done, whether something was found or not.");
    command->callback([options, &action = line.action] {
        action = [options](const Context& context) { return recognise_command(*options, context); };
    });
}

}  // namespace gripscan::app
