// `run environment`: learn what stands still, or look at the cell against what was learned.
#pragma once

#include "app/commands.h"

namespace gripscan::app {

void add_run_environment(CLI::App& run, const CommandLine& line);

}  // namespace gripscan::app
