#include <memory>

#include "app/commands.h"
#include "app/console.h"
#include "app/number_checks.h"
#include "app/progress_bar.h"
#include "app/turn_work.h"
#include "core/base/number_text.h"
#include "core/base/units.h"
#include "core/procedure/auto_turn.h"
#include "core/robot/gsp_link.h"
#include "core/session/cell_file.h"
#include "core/session/journal_file.h"
#include "core/session/session_recorder.h"
#include "core/sim/sim_cell.h"

namespace gripscan::app {
namespace {
namespace fs = std::filesystem;

struct RunOptions {
    std::string cell = "sim";
    std::string out;
    double step_deg = 10.0;
    std::uint64_t seed = 1;
    std::string gripper_model;
    std::string truth;
    TurnOptions turn;
};

Result<SimCell> open_cell(const RunOptions& options) {
    if (options.cell != "sim") {
        const auto cell = load_cell_file(options.cell);
        if (!cell) return forward_error(cell.error());
        if (!cell->robot) return input_error("{} names no robot", options.cell);
        return device_error(
            "robot dialect '{}' of {} is not built into this version; the "
            "simulated cell is: --cell sim",
            cell->robot->dialect, options.cell);
    }
    SimCellSettings settings;
    settings.seed = options.seed;
    settings.step_deg = options.step_deg;
    settings.time_scale = 20.0;  // pictures are what takes time
    if (!options.gripper_model.empty()) settings.gripper = options.gripper_model;
    return SimCell::create(settings);
}

Status check_truth_folder(const RunOptions& options) {
    if (options.truth.empty()) return {};
    const auto inside = absolute_path(options.truth).lexically_relative(absolute_path(options.out));
    if (!inside.empty() && *inside.begin() != "..") {
        return input_error("the truth is written apart: {} lies inside the session {}",
                           options.truth, options.out);
    }
    return {};
}

SessionSpec spec_of(const SimCell& cell, const RunOptions& options) {
    SessionSpec spec;
    spec.step_deg = options.step_deg;
    spec.region = cell.region();
    spec.axis_hint = cell.axis_hint();
    return spec;
}

Status record(SimCell& cell, const RunOptions& options, const Context& context) {
    auto recorder = SessionRecorder::create(options.out, spec_of(cell, options), cell.rig());
    if (!recorder) return forward_error(recorder.error());
    auto journal = JournalFile::open(fs::path(options.out) / "journal");
    if (!journal) return forward_error(journal.error());
    Status begun = journal->write("command", {{"verb", "run gripper"},
                                              {"cell", options.cell},
                                              {"seed", fmt::format("{}", options.seed)},
                                              {"step_deg", text_from_number(options.step_deg)},
                                              {"version", GRIPSCAN_VERSION}});
    if (!begun) return begun;
    AutoTurnSettings settings;
    settings.step_rad = rad_from_deg(options.step_deg);
    settings.start_joint6_rad = cell.start_joint6_rad();
    gsp::GspSettings port;
    port.motion_port = cell.motion_port();
    port.monitor_port = cell.monitor_port();
    port.max_step_deg = 120.0;
    gsp::GspLink robot(port);
    if (const auto connected = robot.connect(); !connected) {
        return forward_error(as_error(connected.error()));
    }
    ProgressBar bar(context);
    const Status taken =
        take_turn(robot, cell.source(), settings, *recorder, *journal, bar.progress());
    const Status noted = journal->write(
        "result",
        {{"verb", "run gripper"}, {"status", taken ? "recorded" : taken.error().message}});
    return taken ? noted : taken;
}

Result<ExitStatus> run_gripper(const RunOptions& options, const Context& context) {
    if (Status apart = check_truth_folder(options); !apart) return forward_error(apart.error());
    auto cell = open_cell(options);
    if (!cell) return forward_error(cell.error());
    if (Status recorded = record(*cell, options, context); !recorded) {
        if (recorded.error().kind == ErrorKind::kCancelled) {
            say(context, fmt::format("stopped; what was recorded lies in {}", options.out));
        }
        return forward_error(recorded.error());
    }
    if (!options.truth.empty()) {
        if (Status s = cell->write_truth(options.truth); !s) return forward_error(s.error());
    }
    const auto work = compute_session(options.out, options.turn, context);
    if (!work) return forward_error(work.error());
    const auto status = deliver(*work, fs::path(options.out) / "results", context);
    if (!status) return status;
    auto journal = JournalFile::open(fs::path(options.out) / "journal");
    if (!journal) return forward_error(journal.error());
    Status noted = journal->write(
        "result",
        {{"verb", "run gripper"}, {"status", *status == kDone ? "accepted" : "not trusted"}});
    if (!noted) return forward_error(noted.error());
    return status;
}

std::string gripper_names() {
    std::string names;
    for (const auto& name : sim_grippers()) names += (names.empty() ? "" : "|") + name;
    return names;
}

}  // namespace

void add_run(const CommandLine& line) {
    auto options = std::make_shared<RunOptions>();
    CLI::App* run = line.app.add_subcommand("run", "The procedure without a window");
    CLI::App* command = run->add_subcommand("gripper", "Register the bare gripper by a whole turn");
    command->add_option("--cell", options->cell, "Cell file, or sim: the simulated cell (sim)")
        ->option_text("FILE|sim");
    command->add_option("--out", options->out, "Session folder to record into")
        ->required()
        ->option_text("DIR");
    command->add_option("--step-deg", options->step_deg, "Step of joint 6 (10)")
        ->check(finite_number())
        ->check(CLI::Range(0.5, 120.0))
        ->option_text("DEG");
    command->add_option("--seed", options->seed, "Of the simulated cell (1)")
        ->check(unsigned_number())
        ->option_text("N");
    command->add_option("--gripper-model", options->gripper_model, "Simulated gripper")
        ->check(CLI::IsMember(sim_grippers()))
        ->option_text(gripper_names());
    command->add_option("--truth", options->truth, "Write the simulator's truth there, apart")
        ->option_text("DIR");
    add_turn_options(*command, options->turn);
    add_common_options(*command, line.common);
    command->footer("Example:\n  gripscan run gripper --cell sim --out monday --seed 3");
    command->callback([options, &action = line.action] {
        action = [options](const Context& context) { return run_gripper(*options, context); };
    });
    need_subcommand(*run);
}

}  // namespace gripscan::app
