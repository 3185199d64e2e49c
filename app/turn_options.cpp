#include "app/turn_options.h"

#include <fmt/format.h>

#include <map>

#include "app/number_checks.h"
#include "core/base/units.h"

namespace gripscan::app {
namespace {

/// Replaces a method's name by its number, as CLI11 reads enums; else says what is known.
std::string method_number(std::string& text) {
    static const std::map<std::string, TurnMethod> kMethods{{"turn", TurnMethod::kTurn},
                                                            {"paper-icp", TurnMethod::kPaperIcp}};
    const auto found = kMethods.find(text);
    if (found == kMethods.end()) return fmt::format("'{}' is neither turn nor paper-icp", text);
    text = std::to_string(static_cast<int>(found->second));
    return {};
}

/// The same for how the gripper is taken away.
std::string trim_number(std::string& text) {
    for (const TrimBy trim : {TrimBy::kAuto, TrimBy::kCuboid, TrimBy::kSurface}) {
        if (text != word(trim)) continue;
        text = std::to_string(static_cast<int>(trim));
        return {};
    }
    return fmt::format("'{}' is none of auto, cuboid, surface", text);
}

}  // namespace

PaperIcpSettings PaperIcpOptions::settings() const {
    PaperIcpSettings settings;
    settings.max_correspondence_m = max_correspondence_mm / kMmPerM;
    settings.iterations = iterations;
    settings.voxel_m = voxel_mm / kMmPerM;
    return settings;
}

void TurnOptions::apply_to(ComputeTurnSettings& settings) const {
    settings.turn.method = method;
    settings.turn.paper_icp = icp.settings();
    settings.crop = !no_crop;
    settings.split.trim = trim;
}

void add_method_options(CLI::App& command, TurnMethod& method, PaperIcpOptions& icp) {
    command
        .add_option("--method", method,
                    "turn: ours; paper-icp: point-to-point ICP from the identity, as published")
        ->transform(CLI::Validator(method_number, ""))
        ->option_text("turn|paper-icp");
    command
        .add_option("--icp-max-correspondence-mm", icp.max_correspondence_mm,
                    "paper-icp: pairs further apart are left out (50)")
        ->check(finite_number())
        ->check(CLI::PositiveNumber)
        ->option_text("MM");
    command.add_option("--icp-iterations", icp.iterations, "paper-icp: iterations at most (10)")
        ->check(CLI::Range(1, 100000))
        ->option_text("N");
    command.add_option("--icp-voxel-mm", icp.voxel_mm, "paper-icp: thinning before (0: none)")
        ->check(finite_number())
        ->check(CLI::NonNegativeNumber)
        ->option_text("MM");
}

void add_turn_options(CLI::App& command, TurnOptions& options) {
    add_method_options(command, options.method, options.icp);
    command
        .add_option("--trim", options.trim,
                    "Of an object's turn, how the gripper is taken away: by its cuboid, by its "
                    "surface, or by the cuboid unless that takes much of the object (auto)")
        ->transform(CLI::Validator(trim_number, ""))
        ->option_text("auto|cuboid|surface");
    command.add_flag("--no-crop", options.no_crop, "Keep points outside the region after matching");
}

}  // namespace gripscan::app
