#include "app/resumed_cell.h"

#include "core/base/atomic_file.h"

namespace gripscan::app {
namespace {

// Those whose default says nothing of whether they were given.
constexpr const char* kCell = "--cell";
constexpr const char* kStep = "--step-deg";
constexpr const char* kSeed = "--seed";

/// The option that contradicts the journal; empty: none.
std::string_view contradiction(const CellOptions& journalled, const CellOptions& asked,
                               const GivenOptions& given) {
    const auto differs = [&](std::string_view name, const auto& wanted, const auto& began) {
        return given.contains(name) && wanted != began;
    };
    if (differs(kStep, asked.step_deg, journalled.step_deg)) return kStep;
    if (differs(kSeed, asked.seed, journalled.seed)) return kSeed;
    if (!asked.faults.empty() && asked.faults != journalled.faults) return "--fault";
    if (!asked.object.empty() && asked.object != journalled.object) return "--object";
    if (!asked.gripper_model.empty() && asked.gripper_model != journalled.gripper_model) {
        return "--gripper-model";
    }
    return {};
}

}  // namespace

GivenOptions given_cell_options(const CLI::App& command) {
    GivenOptions given;
    for (const auto* name : {kCell, kStep, kSeed}) {
        if (command.count(name) > 0) given.insert(name);
    }
    return given;
}

Result<CellOptions> resumed_cell(const CellOptions& journalled, const CellOptions& asked,
                                 const GivenOptions& given) {
    const std::string_view mode = word(journalled.mode());
    if (journalled.simulated() && !asked.simulated()) {
        return input_error(
            "this session began in the simulated cell and cannot go on in {}: begin another one, "
            "with a folder of its own",
            asked.cell);
    }
    if (!journalled.simulated() && asked.simulated() && given.contains(kCell)) {
        return input_error(
            "this session began in {} and cannot go on in the simulated cell: leave --cell out, or "
            "begin another session, with a folder of its own",
            journalled.cell);
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
    if (const auto option = contradiction(journalled, asked, given); !option.empty()) {
        return input_error("{} is not what this session began with: leave it out", option);
    }
    CellOptions options = journalled;
    if (!asked.simulated()) options.cell = asked.cell;
    if (asked.speed_percent) options.speed_percent = asked.speed_percent;
    return options;
}

Status check_cell_file(const std::filesystem::path& session, const CellOptions& resumed) {
    if (resumed.simulated()) return {};
    const auto text = read_whole_file(resumed.cell);
    if (text) return {};
    return input_error(
        "{}; the journal of the session {} names it: if the file has moved, say where it is now "
        "with --cell FILE",
        text.error().message, session.string());
}

}  // namespace gripscan::app
