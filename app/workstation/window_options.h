// The options of the window, on the command line without a subcommand.
#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace gripscan::app {

struct WindowOptions {
    std::string cell;     ///< a cell file; empty: the start page
    std::string session;  ///< a session folder: resumed, looked at, or begun
    bool demo = false;
    std::string screenshot;  ///< PNG of the last frame
    std::size_t frames = 0;  ///< so many, then the window closes; 0: until the user closes it
    std::string script;
    std::string widgets;      ///< file that tells after every frame where the controls are
    std::string frame_times;  ///< file that gets a line for every frame
    std::string size;         ///< WIDTHxHEIGHT, px
    double scale = 0.0;       ///< 0: as the user has set it
};

void add_window_options(CLI::App& app, WindowOptions& options);

}  // namespace gripscan::app
