#include <memory>

#include "app/cell_options.h"
#include "app/cell_out.h"
#include "app/command_run_environment.h"
#include "app/commands.h"
#include "app/console.h"
#include "app/shell_text.h"
#include "app/threads.h"
#include "app/turn_driver.h"
#include "app/turn_run.h"
#include "app/turn_work.h"

namespace gripscan::app {
namespace {
namespace fs = std::filesystem;

struct RunOptions {
    CellOptions cell;
    GivenOptions given;
    std::string out;
    std::string truth;
    std::string gripper;  ///< of an object's turn
    std::string environment;
    bool resume = false;
    TurnOptions turn;
};

/// There has to be something to go on with: a mistyped folder shall not begin a turn. A run that
/// was killed early has left its lock there at least.
Status check_resumed(const RunOptions& options) {
    std::error_code code;
    if (fs::exists(options.out, code) && !fs::is_empty(options.out, code)) return {};
    return input_error(
        "there is no session at {} to resume; without --resume a new one begins there",
        options.out);
}

/// A session is resumed by the command that began it. One whose description cannot be read is
/// refused later, with the reason.
Status check_kind(const RunOptions& options, std::string_view what) {
    if (!options.resume) return {};
    const auto spec = read_session_spec(fs::path(options.out) / "session.yaml");
    if (!spec || word(spec->kind) == what) return {};
    if (spec->kind != SessionKind::kGripper && spec->kind != SessionKind::kObject) {
        return input_error("{} is a session of kind {}, which is not resumed", options.out,
                           word(spec->kind));
    }
    return input_error("{} is a session of kind {}; go on with: gripscan run {} --resume --out {}",
                       options.out, word(spec->kind), word(spec->kind), shell_word(options.out));
}

Status check_run(const RunOptions& options) {
    if (options.resume) {
        if (Status there = check_resumed(options); !there) return there;
    } else if (Status sensible = check(options.cell); !sensible) {
        return sensible;
    }
    if (!options.gripper.empty() && options.resume) {
        return input_error("a resumed session names its gripper itself: leave --gripper out");
    }
    if (!options.environment.empty() && options.resume) {
        return input_error("a resumed session keeps its environment: leave --environment out");
    }
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
        if (Status s = write_truth(*run.cell().simulated, options.truth, context); !s) {
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

Result<ExitStatus> run_turn(const RunOptions& options, std::string_view what,
                            const Context& context) {
    if (Status sensible = check_run(options); !sensible) return forward_error(sensible.error());
    if (Status same = check_kind(options, what); !same) return forward_error(same.error());
    TurnRunOptions run_options{.cell = options.cell,
                               .given = options.given,
                               .out = options.out,
                               .gripper = options.gripper,
                               .environment = options.environment,
                               .resume = options.resume,
                               .turn = options.turn,
                               .threads = thread_count(context)};
    TurnRunViewers viewers;
    viewers.waits = remarks(context);
    auto run = TurnRun::open(run_options, std::move(viewers), context.stop);
    if (!run) return forward_error(run.error());
    const DriverOptions drive{.resumed = (*run)->resumed(),
                              .speed_percent = options.cell.speed_percent};
    const auto driven = drive_turn((*run)->engine(), drive, context);
    if (!driven) {
        say(context, fmt::format("what was recorded lies in {}; go on with: gripscan run {} "
                                 "--resume --out {}{}",
                                 options.out, what, shell_word(options.out),
                                 (*run)->cell_options().live ? " --live" : ""));
        return forward_error(driven.error());
    }
    return finish(**run, *driven, options, context);
}

Result<ExitStatus> run_object(const RunOptions& options, const Context& context) {
    if (options.gripper.empty() && !options.resume) {
        return input_error(
            "--gripper is missing: the template of the gripper that holds the object, as `gripscan "
            "run gripper` leaves it in results/template.pcd");
    }
    if (options.cell.simulated() && options.cell.object.empty() && !options.resume) {
        return input_error("--object is missing: what the simulated gripper holds");
    }
    return run_turn(options, "object", context);
}

/// The options of every turn.
void add_turn_run_options(CLI::App& command, RunOptions& options, CommonOptions& common) {
    add_cell_options(command, options.cell);
    command.add_option("--out", options.out, "Session folder to record into")
        ->required()
        ->option_text("DIR");
    command.add_flag("--resume", options.resume,
                     "Go on with the session in --out where it was interrupted; one that moves a "
                     "real arm is asked for --live again");
    command
        .add_option("--environment", options.environment,
                    "Session of the learned environment (run environment), which is taken away "
                    "from every capture")
        ->option_text("DIR");
    command.add_option("--truth", options.truth, "Write the simulator's truth there, apart")
        ->option_text("DIR");
    add_turn_options(command, options.turn);
    add_common_options(command, common);
}

void add_run_object(CLI::App& run, const CommandLine& line) {
    auto options = std::make_shared<RunOptions>();
    CLI::App* command = run.add_subcommand(
        "object",
        "Register an object in the gripper: the gripper's template is matched into every "
        "capture and taken away, the rest is the object");
    command
        ->add_option("--gripper", options->gripper,
                     "Template of the gripper, with what lies beside it; or its session folder")
        ->option_text("TEMPLATE");
    add_object_option(*command, options->cell);
    add_turn_run_options(*command, *options, line.common);
    command->footer(
        "Examples:\n"
        "  gripscan run object --cell sim --gripper monday --object carton --out carton\n"
        "  gripscan run object --out carton --resume\n"
        "  gripscan run object --cell cell.yaml --gripper monday/results/template.pcd --out part "
        "--live\n"
        "\n"
        "No verdict and no stop of gripscan is a safety function.");
    command->callback([command, options, &action = line.action] {
        options->given = given_cell_options(*command);
        action = [options](const Context& context) { return run_object(*options, context); };
    });
}

}  // namespace

void add_run(const CommandLine& line) {
    auto options = std::make_shared<RunOptions>();
    CLI::App* run = line.app.add_subcommand("run", "The procedure without a window");
    CLI::App* command = run->add_subcommand("gripper", "Register the bare gripper by a whole turn");
    add_turn_run_options(*command, *options, line.common);
    add_run_object(*run, line);
    command->footer(
        "Examples:\n"
        "  gripscan run gripper --cell sim --out monday --seed 3\n"
        "  gripscan run gripper --out monday --resume\n"
        "  gripscan run gripper --cell cell.yaml --out rehearsal      DRY: nothing moves\n"
        "  gripscan run gripper --cell cell.yaml --out tuesday --live\n"
        "\n"
        "No verdict and no stop of gripscan is a safety function.");
    command->callback([command, options, &action = line.action] {
        options->given = given_cell_options(*command);
        action = [options](const Context& context) {
            return run_turn(*options, "gripper", context);
        };
    });
    add_run_environment(*run, line);
    need_subcommand(*run);
}

}  // namespace gripscan::app
