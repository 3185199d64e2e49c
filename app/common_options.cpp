#include "app/commands.h"

namespace gripscan::app {

void add_common_options(CLI::App& command, CommonOptions& common) {
    command.add_flag("--json", common.json,
                     "One JSON document on standard output, everything else on standard error");
    command.add_flag("--quiet", common.quiet, "No progress, no remarks, no table");
    command
        .add_option("--threads", common.threads,
                    "Threads (default: GRIPSCAN_THREADS, else all cores); results do not depend "
                    "on it")
        ->check(CLI::Range(1u, 1024u));
    command.set_version_flag("--version", "gripscan " GRIPSCAN_VERSION);
}

}  // namespace gripscan::app
