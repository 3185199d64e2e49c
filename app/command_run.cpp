#include <memory>

#include "app/cell_options.h"
#include "app/command_run_environment.h"
#include "app/commands.h"
#include "app/console.h"
#include "app/threads.h"
#include "app/turn_driver.h"
#include "app/turn_run.h"
#include "app/turn_work.h"

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

Result<ExitStatus> finish(TurnRun& run, const DrivenTurn& driven, const RunOptions& options,
                          const Context& context) {
    if (!options.truth.empty()) {
        if (Status s = run.cell().simulated->write_truth(options.truth); !s) {
            return forward_error(s.error());
        }
    }
    switch (driven.end) {
        case TurnEnd::kFinished:
        case TurnEnd::kStopped:
            return run.results().deliver(driven.end == TurnEnd::kFinished, context);
        case TurnEnd::kRehearsed:
            tell_rehearsal(driven.state, context);
            return kDone;
        case TurnEnd::kCellRefused:
        case TurnEnd::kNothing:
            tell_refusal(driven.state, context);
            break;
    }
    return kNotTrusted;
}

Result<ExitStatus> run_gripper(const RunOptions& options, const Context& context) {
    if (Status sensible = check_run(options); !sensible) return forward_error(sensible.error());
    auto run = TurnRun::open(
        {options.cell, options.out, options.resume, options.turn, thread_count(context)}, {},
        context.stop);
    if (!run) return forward_error(run.error());
    const auto driven = drive_turn((*run)->engine(), {(*run)->resumed()}, context);
    if (!driven) {
        say(context, fmt::format("what was recorded lies in {}; go on with: gripscan run gripper "
                                 "--resume --out {}",
                                 options.out, options.out));
        return forward_error(driven.error());
    }
    return finish(**run, *driven, options, context);
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
    add_run_environment(*run, line);
    need_subcommand(*run);
}

}  // namespace gripscan::app
