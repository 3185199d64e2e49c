#include "app/resumed_cell.h"

namespace gripscan::app {
namespace {

/// Given, and not what the session began with.
template <typename T>
bool contradicts(const T& asked, const T& standard, const T& journalled) {
    return asked != standard && asked != journalled;
}

/// The option that contradicts the journal; empty: none.
std::string_view contradiction(const CellOptions& journalled, const CellOptions& asked) {
    const CellOptions standard;
    if (contradicts(asked.step_deg, standard.step_deg, journalled.step_deg)) return "--step-deg";
    if (contradicts(asked.seed, standard.seed, journalled.seed)) return "--seed";
    if (contradicts(asked.faults, standard.faults, journalled.faults)) return "--fault";
    if (contradicts(asked.object, standard.object, journalled.object)) return "--object";
    if (contradicts(asked.gripper_model, standard.gripper_model, journalled.gripper_model)) {
        return "--gripper-model";
    }
    return {};
}

}  // namespace

Result<CellOptions> resumed_cell(const CellOptions& journalled, const CellOptions& asked) {
    const std::string_view mode = word(journalled.mode());
    if (journalled.simulated() && !asked.simulated()) {
        return input_error(
            "this session began in the simulated cell and cannot go on in {}: begin another one, "
            "with a folder of its own",
            asked.cell);
    }
    if (asked.live && !journalled.live) {
        return input_error(
            "this session began in {} mode and stays in it; for one that moves the arm begin "
            "another, with a folder of its own",
            mode);
    }
    if (asked.manual && !journalled.manual) {
        return input_error(
            "this session began in {} mode and stays in it; for one without motion rights begin "
            "another, with a folder of its own",
            mode);
    }
    if (journalled.live && !asked.live) {
        return input_error("this session is LIVE, it moves the arm: resume it with --live");
    }
    if (const auto option = contradiction(journalled, asked); !option.empty()) {
        return input_error("{} is not what this session began with: leave it out", option);
    }
    CellOptions options = journalled;
    if (!asked.simulated()) options.cell = asked.cell;
    if (asked.speed_percent) options.speed_percent = asked.speed_percent;
    return options;
}

}  // namespace gripscan::app
