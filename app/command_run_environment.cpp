#include "app/command_run_environment.h"

#include <poll.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <iostream>
#include <memory>

#include "app/console.h"
#include "app/environment_work.h"
#include "app/number_checks.h"
#include "app/progress_bar.h"
#include "app/results_of.h"
#include "app/threads.h"
#include "app/turn_work.h"
#include "core/base/units.h"
#include "core/scene/environment_file.h"
#include "core/session/alignment_file.h"

namespace gripscan::app {
namespace {
namespace fs = std::filesystem;

struct EnvironmentOptions {
    CellOptions cell;
    std::string out;
    std::string check;
    std::string gripper;
    std::string alignment;
    int captures = 8;
    bool arm_in_view = false;
};

/// Where a person would jog the simulated arm to, deg: the arm comes from all sides.
constexpr std::array<std::array<double, 5>, 8> kSimulatedPoses = {{{-2, -4, 1.5, 7, -3},
                                                                   {35, -20, 20, 0, -40},
                                                                   {-40, 10, -10, 30, 20},
                                                                   {70, 0, 30, 0, 0},
                                                                   {-75, -10, 10, -20, -30},
                                                                   {15, 35, -25, 60, 50},
                                                                   {-20, -40, 40, -60, -60},
                                                                   {100, 20, 0, 0, -90}}};

/// False where the input has ended or the command was cancelled.
bool enter_pressed(const std::stop_token& stop) {
    constexpr int kLook_ms = 100;
    pollfd input{STDIN_FILENO, POLLIN, 0};
    while (!stop.stop_requested()) {
        if (::poll(&input, 1, kLook_ms) <= 0) continue;
        std::string line;
        return static_cast<bool>(std::getline(std::cin, line));
    }
    return false;
}

/// Makes the arm stand elsewhere before the next capture; the simulated one by itself.
Status move_arm(const EnvironmentOptions& options, int capture, Cell& cell,
                const Context& context) {
    if (!options.arm_in_view || capture == 0) return {};
    if (!options.cell.simulated()) {
        say(context,
            fmt::format("capture {}: move the arm elsewhere, then press Enter", capture + 1));
        if (enter_pressed(context.stop)) return {};
        return context.stop.stop_requested()
                   ? Status(cancelled_error())
                   : Status(input_error("the input ended before the last capture was taken"));
    }
    CellOptions again = options.cell;
    again.other_joints_deg =
        kSimulatedPoses[static_cast<std::size_t>(capture) % kSimulatedPoses.size()];
    auto moved = open_cell(again, context.stop, remarks(context));
    if (!moved) return forward_error(moved.error());
    cell = std::move(*moved);
    return {};
}

Result<Cell> open(const EnvironmentOptions& options, const Context& context) {
    CellOptions cell = options.cell;
    cell.arm_away = !options.arm_in_view;
    cell.manual = !cell.simulated();  // nothing is moved, so a cell without a robot will do
    return open_cell(cell, context.stop, remarks(context));
}

Result<ExitStatus> learn(const EnvironmentOptions& options, const Context& context) {
    auto cell = open(options, context);
    if (!cell) return forward_error(cell.error());
    {
        auto store = begin_environment(options.out, options.cell, *cell, options.arm_in_view);
        if (!store) return forward_error(store.error());
        ProgressBar bar(context);
        const auto before = [&](int capture, Cell& of) {
            return move_arm(options, capture, of, context);
        };
        Status done = record_environment(*cell, *store, options.captures, before, bar.progress());
        if (!done) return forward_error(done.error());
    }
    const auto session = open_session(options.out);
    if (!session) return forward_error(session.error());
    return replay_environment(*session, fs::path(options.out) / "results", context);
}

/// The registered gripper, turned to where joint 6 stands now.
struct RegisteredGripper {
    Cloud merged;
    Pose T_camera_cloud = Pose::Identity();
};

Result<RegisteredGripper> gripper_at(const fs::path& session, double joint6_rad,
                                     const Context& context) {
    auto results = results_of(session, context);
    if (!results) return forward_error(results.error());
    const CaptureTable& table = results->session.table;
    const auto first =
        std::find_if(table.rows.begin(), table.rows.end(),
                     [](const CaptureRow& row) { return row.status == CaptureStatus::kUsed; });
    if (!results->report.axis || first == table.rows.end() || !first->joints_deg[5]) {
        return input_error(
            "{}: the gripper's axis or joint 6 of its first capture is not known, so it cannot be "
            "turned to where it stands now",
            session.string());
    }
    const double turned_rad = joint6_rad - rad_from_deg(*first->joints_deg[5]);
    return RegisteredGripper{std::move(results->report.merged),
                             turn_about(results->report.axis->axis, turned_rad)};
}

Result<ExitStatus> check_cell(const EnvironmentOptions& options, const Context& context) {
    const auto model = load_environment(options.check);
    if (!model) return forward_error(model.error());
    auto cell = open(options, context);
    if (!cell) return forward_error(cell.error());
    const auto rectifier = Rectifier::create(cell->rig);
    if (!rectifier) return forward_error(rectifier.error());
    SceneKnowledge knowledge;
    knowledge.region = cell->region;
    if (!options.alignment.empty()) {
        const auto aligned = load_robot_camera(options.alignment);
        if (!aligned) return forward_error(aligned.error());
        cell->T_robot_camera = *aligned;
    }
    std::optional<RegisteredGripper> gripper;
    KnownThing thing;
    if (options.arm_in_view && cell->robot) {
        if (auto up = cell->robot->connect(); !up) return forward_error(as_error(up.error()));
        const auto reading = cell->robot->read();
        if (!reading) return forward_error(as_error(reading.error()));
        if (cell->T_robot_camera) knowledge.arm.emplace(reading->joints_rad, *cell->T_robot_camera);
        if (!options.gripper.empty()) {
            auto made = gripper_at(options.gripper, reading->joints_rad[5], context);
            if (!made) return forward_error(made.error());
            gripper = std::move(*made);
            thing = {&gripper->merged, gripper->T_camera_cloud};
            knowledge.things = std::span<const KnownThing>(&thing, 1);
        }
    }
    WorkerPool pool(thread_count(context));
    // A number of its own, so that the simulated noise is not that of a learned capture.
    constexpr int kLook = 100000;
    const auto frame = cell->camera->grab({kLook, 1, 0});
    if (!frame) return forward_error(frame.error());
    ProgressBar bar(context);
    const auto scene = whole_cloud(*frame, *rectifier, bar.progress(), pool.for_each());
    if (!scene) return forward_error(scene.error());
    const auto survey =
        survey_scene(*model, *scene, knowledge, {}, bar.progress(), pool.for_each());
    if (!survey) return forward_error(survey.error());
    return tell_survey(*survey, context);
}

Result<ExitStatus> run_environment(const EnvironmentOptions& options, const Context& context) {
    if (options.out.empty() == options.check.empty()) {
        return input_error(
            "give --out to learn the environment, or --check to look at the cell "
            "against one that was learned");
    }
    if (!options.gripper.empty() && (options.check.empty() || !options.arm_in_view)) {
        return input_error("--gripper goes with --check and --arm-in-view");
    }
    return options.check.empty() ? learn(options, context) : check_cell(options, context);
}

}  // namespace

void add_run_environment(CLI::App& run, const CommandLine& line) {
    auto options = std::make_shared<EnvironmentOptions>();
    CLI::App* command = run.add_subcommand(
        "environment", "Learn what stands still, or look at the cell against what was learned");
    command->add_option("--cell", options->cell.cell, "Cell file, or sim: the simulated cell (sim)")
        ->option_text("FILE|sim");
    command->add_option("--out", options->out, "Session folder to record into")->option_text("DIR");
    command
        ->add_option("--check", options->check,
                     "Take one picture and say what has come or moved since this was learned")
        ->option_text("DIR");
    command->add_option("--captures", options->captures, "How many (8)")
        ->check(CLI::Range(3, 255))
        ->option_text("N");
    command->add_flag("--arm-in-view", options->arm_in_view,
                      "The arm stands in the picture: elsewhere in every capture while learning; "
                      "taken away by its joints and the alignment while checking");
    command
        ->add_option("--gripper", options->gripper,
                     "Session of the registered gripper, which is then nothing strange")
        ->option_text("SESSION");
    command
        ->add_option("--alignment", options->alignment, "Robot-camera alignment (the cell's own)")
        ->option_text("FILE");
    command->add_option("--seed", options->cell.seed, "Of the simulated cell (1)")
        ->transform(unsigned_number())
        ->option_text("N");
    command
        ->add_option("--fault", options->cell.faults,
                     "Of the simulated cell, see docs/faults.md; may be given several times")
        ->allow_extra_args(false)
        ->option_text("NAME[@STEP][=VALUE]");
    add_common_options(*command, line.common);
    command->footer(
        "Examples:\n"
        "  gripscan run environment --cell sim --out room\n"
        "  gripscan run environment --cell sim --check room --fault tool@0\n"
        "  gripscan run environment --cell cell.yaml --out room --arm-in-view");
    command->callback([options, &action = line.action] {
        action = [options](const Context& context) { return run_environment(*options, context); };
    });
}

}  // namespace gripscan::app
