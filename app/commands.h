// The subcommands. Each adds itself to the command line; when it is the one that was chosen, it
// sets what to do.
#pragma once

#include <CLI/CLI.hpp>

#include "app/context.h"

namespace gripscan::app {

/// Where a subcommand leaves what was asked of it.
struct CommandLine {
    CLI::App& app;
    CommonOptions& common;
    Action& action;
};

void add_run(const CommandLine& line);
void add_replay(const CommandLine& line);
void add_align(const CommandLine& line);
void add_stereo(const CommandLine& line);
void add_calibrate(const CommandLine& line);
void add_export(const CommandLine& line);
void add_report(const CommandLine& line);
void add_robot_check(const CommandLine& line);
void add_simcell(const CommandLine& line);
void add_recognise(const CommandLine& line);
void add_library(const CommandLine& line);
void add_exam(const CommandLine& line);

/// For a command that only groups others, once those are added: without one it names them.
void need_subcommand(CLI::App& group);

/// --json, --quiet, --threads and --version, which every subcommand takes.
void add_common_options(CLI::App& command, CommonOptions& common);

}  // namespace gripscan::app
