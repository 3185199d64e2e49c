#include "app/cell_options.h"

#include <algorithm>
#include <filesystem>

#include "app/number_checks.h"
#include "core/base/number_text.h"
#include "core/robot/joint6_limits.h"
#include "core/sim/sim_cell.h"

namespace gripscan::app {
namespace {

std::string joined(const std::vector<std::string>& texts, std::string_view separator) {
    std::string all;
    for (const auto& text : texts) {
        if (!all.empty()) all += separator;
        all += text;
    }
    return all;
}

std::vector<std::string> split(const std::string& text, char separator) {
    std::vector<std::string> parts;
    std::size_t begin = 0;
    while (begin < text.size()) {
        const auto end = std::min(text.find(separator, begin), text.size());
        parts.push_back(text.substr(begin, end - begin));
        begin = end + 1;
    }
    return parts;
}

/// A session may be resumed from another folder than the one it was begun from.
std::string remembered_cell(const CellOptions& options) {
    if (options.simulated()) return options.cell;
    std::error_code code;
    const auto path = std::filesystem::absolute(options.cell, code);
    return code ? options.cell : path.lexically_normal().string();
}

}  // namespace

MotionMode CellOptions::mode() const {
    if (manual) return MotionMode::kManual;
    if (simulated()) return MotionMode::kSim;
    return live ? MotionMode::kLive : MotionMode::kDry;
}

void add_cell_options(CLI::App& command, CellOptions& options) {
    command.add_option("--cell", options.cell, "Cell file, or sim: the simulated cell (sim)")
        ->option_text("FILE|sim");
    command.add_option("--step-deg", options.step_deg, "Step of joint 6 (10)")
        ->check(finite_number())
        ->check(CLI::Range(kLeastStep_deg, kMostStep_deg))
        ->option_text("DEG");
    command.add_flag("--live", options.live,
                     "Move a real arm; without it motions are written down and not sent (DRY)");
    command.add_option("--speed", options.speed_percent, "Of joint 6 (the cell file's, else 10)")
        ->check(finite_number())
        ->check(CLI::Range(kLeastSpeed_percent, kMostSpeed_percent))
        ->option_text("PERCENT");
    command.add_flag("--manual", options.manual,
                     "No motion rights: turn the joint with the pendant, gripscan reads the angle "
                     "or is told");
    command.add_option("--seed", options.seed, "Of the simulated cell (1)")
        ->transform(unsigned_number())
        ->option_text("N");
    command.add_option("--gripper-model", options.gripper_model, "Simulated gripper")
        ->check(CLI::IsMember(sim_grippers()))
        ->option_text(joined(sim_grippers(), "|"));
    command
        .add_option("--fault", options.faults,
                    "Of the simulated cell, see docs/faults.md; may be given several times")
        ->allow_extra_args(false)
        ->option_text("NAME[@STEP][=VALUE]");
}

void add_object_option(CLI::App& command, CellOptions& options) {
    command.add_option("--object", options.object, "What the simulated gripper holds")
        ->check(CLI::IsMember(sim_objects()))
        ->option_text(joined(sim_objects(), "|"));
}

Status check(const CellOptions& options) {
    if (options.live && options.manual) {
        return input_error("--live moves the arm and --manual may not: choose one");
    }
    if (options.simulated() && options.live) {
        return input_error("--live is for a real controller; the simulated cell moves without it");
    }
    if (!options.simulated() &&
        (!options.faults.empty() || !options.gripper_model.empty() || !options.object.empty())) {
        return input_error(
            "--fault, --gripper-model and --object belong to the simulated cell, not to {}",
            options.cell);
    }
    return {};
}

JournalFields journal_fields(const CellOptions& options) {
    JournalFields fields{{"cell", remembered_cell(options)},
                         {"mode", std::string(word(options.mode()))},
                         {"step_deg", text_from_number(options.step_deg)},
                         {"seed", fmt::format("{}", options.seed)},
                         {"gripper_model", options.gripper_model},
                         {"object", options.object},
                         {"faults", joined(options.faults, " ")}};
    if (options.speed_percent) {
        fields.emplace_back("speed_percent", text_from_number(*options.speed_percent));
    }
    return fields;
}

Result<CellOptions> cell_options_from(const JournalFields& fields) {
    CellOptions options;
    for (const auto& [name, value] : fields) {
        if (name == "cell") options.cell = value;
        if (name == "mode") {
            options.live = value == word(MotionMode::kLive);
            options.manual = value == word(MotionMode::kManual);
        }
        if (name == "gripper_model") options.gripper_model = value;
        if (name == "object") options.object = value;
        if (name == "faults") options.faults = split(value, ' ');
        if (name == "seed") options.seed = std::strtoull(value.c_str(), nullptr, 10);
        if (name != "step_deg" && name != "speed_percent") continue;
        const auto number = number_from_text(value);
        if (!number) return input_error("the journal's {} is no number: '{}'", name, value);
        if (name == "step_deg") options.step_deg = *number;
        if (name == "speed_percent") options.speed_percent = *number;
    }
    return options;
}

}  // namespace gripscan::app
