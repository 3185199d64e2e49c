#include <fmt/ranges.h>

#include <condition_variable>
#include <memory>
#include <mutex>
#include <nlohmann/json.hpp>

#include "app/cell_out.h"
#include "app/commands.h"
#include "app/console.h"
#include "app/number_checks.h"
#include "core/robot/gsp_message.h"
#include "core/sim/fault_plan.h"
#include "core/sim/sim_cell.h"

namespace gripscan::app {
namespace {

struct SimcellOptions {
    SimCellSettings cell;
    std::string cell_out;
    std::string truth;
};

void wait_for(const std::stop_token& stop) {
    std::mutex mutex;
    std::unique_lock lock(mutex);
    std::condition_variable_any never;
    never.wait(lock, stop, [] { return false; });
}

std::string text_of(const SimCell& cell) {
    return fmt::format("listening motion={} monitor={} frames={}\n", cell.motion_port(),
                       cell.monitor_port(), *cell.frames_port());
}

/// One line: it is read while the cell serves.
std::string json_of(const SimCell& cell) {
    const nlohmann::ordered_json json{{"format", "gripscan-simcell/1"},
                                      {"motion_port", cell.motion_port()},
                                      {"monitor_port", cell.monitor_port()},
                                      {"frames_port", *cell.frames_port()}};
    return json.dump() + "\n";
}

Result<ExitStatus> serve(const SimcellOptions& options, const Context& context) {
    auto cell = SimCell::create(options.cell);
    if (!cell) return forward_error(cell.error());
    if (!options.cell_out.empty()) {
        if (Status s = write_cell_files(*cell, options.cell_out); !s) {
            return forward_error(s.error());
        }
    }
    print_result(context.options.json ? json_of(*cell) : text_of(*cell));
    wait_for(context.stop);
    if (!options.truth.empty()) {
        if (Status s = write_truth(*cell, options.truth, context); !s) {
            return forward_error(s.error());
        }
    }
    return kDone;
}

std::string names_of_faults() {
    std::string names;
    for (const sim::FaultInfo& fault : sim::fault_table()) {
        names += fmt::format("{}{}", names.empty() ? "" : " ", fault.name);
    }
    return names;
}

}  // namespace

void add_simcell(const CommandLine& line) {
    auto options = std::make_shared<SimcellOptions>();
    options->cell.port = gsp::kMotionPort;
    options->cell.serve_frames = true;
    CLI::App* command =
        line.app.add_subcommand("simcell", "The simulated cell as a server, until it is stopped");
    command
        ->add_option("--port", options->cell.port,
                     "Motion; monitor and frames follow; 0: free ports (18740)")
        ->check(CLI::Range(0, 65533))
        ->option_text("P");
    command->add_option("--seed", options->cell.seed, "Of the cell (1)")
        ->transform(unsigned_number())
        ->option_text("N");
    command
        ->add_option("--fault", options->cell.faults,
                     "Goes wrong, also several: " + names_of_faults())
        ->option_text("NAME[@STEP][=VALUE] ...");
    command->add_option("--gripper-model", options->cell.gripper, "Simulated gripper (two-finger)")
        ->check(CLI::IsMember(sim_grippers()))
        ->option_text(fmt::format("{}", fmt::join(sim_grippers(), "|")));
    command->add_option("--step-deg", options->cell.step_deg, "By which faults count steps (10)")
        ->check(finite_number())
        ->option_text("DEG");
    command->add_option("--time-scale", options->cell.time_scale, "The arm, times as fast (1)")
        ->check(finite_number())
        ->option_text("F");
    command
        ->add_option("--cell-out", options->cell_out, "Write cell.yaml and rig.yaml for it there")
        ->option_text("DIR");
    command
        ->add_option("--truth", options->truth,
                     "When stopped, write the truth of the captures served")
        ->option_text("DIR");
    add_common_options(*command, line.common);
    command->footer(
        "Example:\n  gripscan simcell --port 0 --seed 3 --fault slip@5 --cell-out cell");
    command->callback([options, &action = line.action] {
        action = [options](const Context& context) { return serve(*options, context); };
    });
}

}  // namespace gripscan::app
