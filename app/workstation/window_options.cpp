#include "app/workstation/window_options.h"

namespace gripscan::app {

void add_window_options(CLI::App& app, WindowOptions& options) {
    constexpr const char* kGroup = "Window";
    app.add_option("--cell", options.cell, "Begin a session in this cell")
        ->option_text("FILE")
        ->group(kGroup);
    app.add_option("--session", options.session,
                   "Session folder: begun where there is none, resumed where it was interrupted, "
                   "else shown")
        ->option_text("DIR")
        ->group(kGroup);
    app.add_flag("--demo", options.demo, "A guided session in the simulated cell")->group(kGroup);
    app.add_option("--screenshot", options.screenshot, "Write a picture of the last frame, PNG")
        ->option_text("FILE")
        ->group(kGroup);
    app.add_option("--frames", options.frames, "Close after so many frames")
        ->option_text("N")
        ->group(kGroup);
    app.add_option("--script", options.script,
                   "Press controls as the file says (docs/window-scripts.md), then close")
        ->option_text("FILE")
        ->group(kGroup);
    app.add_option("--widgets", options.widgets,
                   "Keep a list of the controls and their places in this file, JSON")
        ->option_text("FILE")
        ->group(kGroup);
    app.add_option("--frame-times", options.frame_times,
                   "Write how long each frame took into this file, CSV")
        ->option_text("FILE")
        ->group(kGroup);
    app.add_option("--size", options.size, "Size of the window, px")
        ->option_text("WIDTHxHEIGHT")
        ->group(kGroup);
    app.add_option("--scale", options.scale, "Factor on the monitor's own scale")
        ->check(CLI::Range(0.5, 3.0))
        ->option_text("FACTOR")
        ->group(kGroup);
}

}  // namespace gripscan::app
