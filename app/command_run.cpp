#include <memory>

#include "app/cell_options.h"
#include "app/commands.h"
#include "app/console.h"
#include "app/open_cell.h"
#include "app/run_results.h"
#include "app/threads.h"
#include "app/turn_driver.h"
#include "app/turn_session.h"
#include "app/turn_work.h"
#include "core/procedure/cell_effects.h"
#include "core/procedure/link_watch.h"
#include "core/procedure/region_stillness.h"

namespace gripscan::app {
namespace {
namespace fs = std::filesystem;

struct RunOptions {
    CellOptions cell;
    std::string out;
    std::string truth;
    bool resume = false;
    TurnOptions turn;
};

Status check_run(const RunOptions& options) {
    if (Status sensible = check(options.cell); !sensible) return sensible;
    if (options.truth.empty()) return {};
    if (!options.cell.simulated() || options.resume) {
        return input_error(
            "--truth is what the simulated cell of this run knows; {}",
            options.resume ? "of a resumed one it knows the last part only" : "this is a real one");
    }
    const auto inside = absolute_path(options.truth).lexically_relative(absolute_path(options.out));
    if (!inside.empty() && *inside.begin() != "..") {
        return input_error("the truth is written apart: {} lies inside the session {}",
                           options.truth, options.out);
    }
    return {};
}

/// Everything of a run that has to live as long as its engine.
struct Run {
    Cell cell;
    TurnSession session;
    bool resumed = false;
};

Result<Run> open_run(const RunOptions& options) {
    if (!options.resume || is_fresh_session(options.out)) {
        auto cell = open_cell(options.cell);
        if (!cell) return forward_error(cell.error());
        auto session = begin_session(options.out, options.cell, *cell);
        if (!session) return forward_error(session.error());
        return Run{std::move(*cell), std::move(*session), false};
    }
    auto remembered = remember_session(options.out);
    if (!remembered) return forward_error(remembered.error());
    // Which cell it was is known; a cell file may say again where it is now.
    CellOptions cell_options = remembered->options;
    if (!options.cell.simulated()) cell_options.cell = options.cell.cell;
    auto cell = open_cell(cell_options);
    if (!cell) return forward_error(cell.error());
    return Run{std::move(*cell),
               TurnSession{std::move(remembered->store), std::move(remembered->spec),
                           std::move(remembered->state)},
               true};
}

Result<CellEffects> effects_of(Run& run, const RunOptions& options, ResultKeeper& results,
                               const ForEach& for_each) {
    ComputeTurnSettings settings =
        compute_settings_of(Session{options.out, run.session.spec, run.cell.rig, {}});
    options.turn.apply_to(settings);
    auto workspace = TurnWorkspace::create(run.cell.rig, run.session.spec.region, settings);
    if (!workspace) return forward_error(workspace.error());
    auto differs = region_stillness(run.cell.rig, run.session.spec.region);
    if (!differs) return forward_error(differs.error());
    CellEquipment equipment{.robot = run.cell.robot.get(),
                            .source = *run.cell.camera,
                            .rig = run.cell.rig,
                            .region = run.session.spec.region,
                            .axis_hint = run.session.spec.axis_hint,
                            .T_robot_camera = run.cell.T_robot_camera,
                            .session = options.out,
                            .exposure = {.settle_s = run.cell.settle_s},
                            .differs = std::move(*differs)};
    return CellEffects(std::move(equipment), std::move(*workspace), run.session.store, results,
                       for_each);
}

Result<DrivenTurn> drive(Run& run, const RunOptions& options, RunResults& results,
                         const Context& context) {
    WorkerPool pool(thread_count(context));
    auto effects = effects_of(run, options, results, pool.for_each());
    if (!effects) return forward_error(effects.error());
    Engine engine(std::move(run.session.state), *effects, run.session.store,
                  run.session.store.journal());
    std::optional<LinkWatch> watch;
    if (run.cell.robot) watch.emplace(*run.cell.robot, engine);
    if (run.resumed) {
        engine.tell(event::ProgramEnded{});
        if (auto taken = engine.pump(std::chrono::seconds(1)); !taken) {
            return forward_error(taken.error());
        }
    }
    return drive_turn(engine, {run.resumed}, context);
}

Result<ExitStatus> run_gripper(const RunOptions& options, const Context& context) {
    if (Status sensible = check_run(options); !sensible) return forward_error(sensible.error());
    auto run = open_run(options);
    if (!run) return forward_error(run.error());
    RunResults results(options.out, options.turn);
    const auto driven = drive(*run, options, results, context);
    if (!driven) {
        say(context, fmt::format("what was recorded lies in {}; go on with: gripscan run gripper "
                                 "--resume --out {}",
                                 options.out, options.out));
        return forward_error(driven.error());
    }
    if (!options.truth.empty()) {
        if (Status s = run->cell.simulated->write_truth(options.truth); !s) {
            return forward_error(s.error());
        }
    }
    switch (driven->end) {
        case TurnEnd::kFinished:
        case TurnEnd::kStopped:
            return results.deliver(driven->end == TurnEnd::kFinished, context);
        case TurnEnd::kRehearsed:
            tell_rehearsal(driven->state, context);
            return kDone;
        case TurnEnd::kCellRefused:
        case TurnEnd::kNothing:
            tell_refusal(driven->state, context);
            break;
    }
    return kNotTrusted;
}

}  // namespace

void add_run(const CommandLine& line) {
    auto options = std::make_shared<RunOptions>();
    CLI::App* run = line.app.add_subcommand("run", "The procedure without a window");
    CLI::App* command = run->add_subcommand("gripper", "Register the bare gripper by a whole turn");
    add_cell_options(*command, options->cell);
    command->add_option("--out", options->out, "Session folder to record into")
        ->required()
        ->option_text("DIR");
    command->add_flag("--resume", options->resume,
                      "Go on with the session in --out where it was interrupted");
    command->add_option("--truth", options->truth, "Write the simulator's truth there, apart")
        ->option_text("DIR");
    add_turn_options(*command, options->turn);
    add_common_options(*command, line.common);
    command->footer(
        "Examples:\n"
        "  gripscan run gripper --cell sim --out monday --seed 3\n"
        "  gripscan run gripper --out monday --resume\n"
        "  gripscan run gripper --cell cell.yaml --out rehearsal      DRY: nothing moves\n"
        "  gripscan run gripper --cell cell.yaml --out tuesday --live\n"
        "\n"
        "No verdict and no stop of gripscan is a safety function.");
    command->callback([options, &action = line.action] {
        action = [options](const Context& context) { return run_gripper(*options, context); };
    });
    need_subcommand(*run);
}

}  // namespace gripscan::app
