// The program: options, wiring, exit status.

#include <opencv2/core/utility.hpp>

#include "app/commands.h"
#include "app/console.h"
#include "app/help_formatter.h"
#include "app/interrupt.h"
#include "app/standard_streams.h"
#ifdef GRIPSCAN_GUI
#include "app/workstation/run_window.h"
#endif

namespace gripscan::app {
namespace {

constexpr const char* kFooter =
    "Without a command: the workstation's window, on the simulated cell or the one of --cell.\n"
    "\n"
    "Examples:\n"
    "  gripscan                                         the window\n"
    "  gripscan run gripper --cell sim --out monday     a whole turn in the simulated cell\n"
    "  gripscan replay monday --out /tmp/again --json   the same recording computed again\n"
    "  gripscan report monday                           Table 1 as CSV and as a page\n"
    "  gripscan export monday --out gripper.ply --unit mm\n"
    "\n"
    "Exit status: 0 every step accepted, 1 done but not to be trusted, 2 wrong usage or input,\n"
    "3 device or link, 4 cancelled.";

#ifdef GRIPSCAN_GUI
/// Without a subcommand: the window.
Action window_action(CLI::App& app) {
    auto options = std::make_shared<WindowOptions>();
    add_window_options(app, *options);
    return [options](const Context& context) { return run_window(*options, context); };
}
#else
Action window_action(CLI::App& app) {
    return [name = app.get_name()](const Context&) -> Result<ExitStatus> {
        return input_error("this build has no window; see `{} --help`", name);
    };
}
#endif

int run(const Action& action, const CommonOptions& common) {
    const Interrupt interrupt;
    // Captures run side by side on our own threads; OpenCV adds none of its own.
    cv::setNumThreads(1);
    try {
        const auto status = action(Context{common, interrupt.token()});
        if (!status) return report_error(status.error());
        if (!results_printed()) {
            return report_error(
                input_error("the result could not be written to standard output").value());
        }
        return *status;
    } catch (const std::bad_alloc&) {
        return report_error(input_error("not enough memory").value());
    } catch (const std::exception& e) {
        return report_error(input_error("internal error: {}; please report it", e.what()).value());
    }
}

int parse_and_run(int argc, char** argv) {
    CLI::App app("gripscan: point clouds of a robot's gripper, checked against the robot",
                 "gripscan");
    app.set_version_flag("--version", "gripscan " GRIPSCAN_VERSION);
    app.require_subcommand(0, 1);
    app.formatter(std::make_shared<HelpFormatter>());
    app.footer(kFooter);
    CommonOptions common;
    Action action = window_action(app);
    const CommandLine line{app, common, action};
    add_run(line);
    add_replay(line);
    add_align(line);
    add_stereo(line);
    add_calibrate(line);
    add_export(line);
    add_report(line);
    add_robot_check(line);
    add_simcell(line);
    add_recognise(line);
    add_library(line);
    add_exam(line);
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& e) {
        return app.exit(e) == 0 ? kDone : kWrongInput;
    }
    return run(action, common);
}

}  // namespace
}  // namespace gripscan::app

int main(int argc, char** argv) {
    gripscan::app::keep_standard_streams();
    return gripscan::app::parse_and_run(argc, argv);
}
