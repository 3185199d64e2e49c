#include <memory>

#include "app/commands.h"
#include "app/environment_work.h"
#include "app/turn_work.h"
#include "core/report/results_folder.h"

namespace gripscan::app {
namespace {

struct ReplayOptions {
    std::string session;
    std::string out;
    TurnOptions turn;
};

Result<ExitStatus> replay(const ReplayOptions& options, const Context& context) {
    const std::filesystem::path session = options.session;
    const std::filesystem::path out =
        options.out.empty() ? session / "results" : std::filesystem::path(options.out);
    // Opening first: a wrong session is the more useful message.
    const auto opened = open_session(session);
    if (!opened) return forward_error(opened.error());
    if (opened->spec.kind == SessionKind::kEnvironment) {
        return replay_environment(*opened, out, context);
    }
    if (Status target = check_results_target(session, out); !target) {
        return forward_error(target.error());
    }
    const auto work = compute_session(session, options.turn, context);
    if (!work) return forward_error(work.error());
    return deliver(*work, out, context);
}

}  // namespace

void add_replay(const CommandLine& line) {
    auto options = std::make_shared<ReplayOptions>();
    CLI::App* command = line.app.add_subcommand("replay", "Compute a recorded session again");
    command->add_option("session", options->session, "Session folder; it is not changed")
        ->required()
        ->option_text("SESSION");
    command->add_option("--out", options->out, "Results folder (SESSION/results)")
        ->option_text("DIR");
    add_turn_options(*command, options->turn);
    add_common_options(*command, line.common);
    command->footer(
        "Example:\n  gripscan replay monday --out /tmp/monday\n  gripscan replay monday "
        "--out /tmp/paper --method paper-icp --json > paper.json");
    command->callback([options, &action = line.action] {
        action = [options](const Context& context) { return replay(*options, context); };
    });
}

}  // namespace gripscan::app
