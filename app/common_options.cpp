#include <fmt/format.h>

#include "app/commands.h"

namespace gripscan::app {

void need_subcommand(CLI::App& group) {
    std::string names;
    for (const auto* command : group.get_subcommands(nullptr)) names += " " + command->get_name();
    group.footer(fmt::format("See `gripscan {} COMMAND --help`.", group.get_name()));
    group.require_subcommand(0, 1);
    group.callback([&group, names] {
        if (!group.get_subcommands().empty()) return;
        throw CLI::RequiredError(fmt::format("gripscan {}: say which:{}", group.get_name(), names),
                                 CLI::ExitCodes::RequiredError);
    });
}

void add_common_options(CLI::App& command, CommonOptions& common) {
    command.add_flag("--json", common.json,
                     "One JSON document on standard output, everything else on standard error");
    command.add_flag("--quiet", common.quiet, "No progress, no remarks, no table");
    command
        .add_option("--threads", common.threads,
                    "Threads (default: GRIPSCAN_THREADS, else all cores); results do not depend "
                    "on it")
        ->check(CLI::Range(1u, 1024u))
        ->option_text("N");
    command.set_version_flag("--version", "gripscan " GRIPSCAN_VERSION);
}

}  // namespace gripscan::app
