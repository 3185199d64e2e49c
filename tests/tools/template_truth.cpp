// template_truth TEMPLATE TRUTH_DIR [--object] [--turns TURNS.json --captures CAPTURES.csv]
// Measures a template (and the poses it was merged with) against the simulated cell's truth.
#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <iostream>
#include <nlohmann/json.hpp>

#include "core/cloud/cloud_file.h"
#include "tests/tools/pose_score.h"
#include "tests/tools/template_score.h"

namespace gripscan::test {
namespace {

using nlohmann::ordered_json;

struct Arguments {
    std::string template_file;
    std::string truth_folder;
    std::string turns_json;
    std::string captures_csv;
    bool object = false;
};

ordered_json json_of(const TemplateScore& score) {
    return {{"points", score.points},     {"rms_mm", score.rms_mm},  {"p50_mm", score.p50_mm},
            {"p90_mm", score.p90_mm},     {"p99_mm", score.p99_mm},  {"max_mm", score.max_mm},
            {"coverage", score.coverage}, {"foreign", score.foreign}};
}

ordered_json json_of(const std::vector<PoseError>& errors) {
    ordered_json rows = ordered_json::array();
    double worst_deg = 0.0;
    double worst_mm = 0.0;
    for (const PoseError& error : errors) {
        rows.push_back({{"capture", error.capture},
                        {"rotation_deg", error.rotation_deg},
                        {"shift_mm", error.shift_mm}});
        worst_deg = std::max(worst_deg, error.rotation_deg);
        worst_mm = std::max(worst_mm, error.shift_mm);
    }
    return {{"worst_deg", worst_deg}, {"worst_mm", worst_mm}, {"captures", rows}};
}

ordered_json json_of(const std::vector<StepError>& errors) {
    ordered_json rows = ordered_json::array();
    double sum = 0.0;
    double worst = 0.0;
    std::size_t measured = 0;
    for (const StepError& error : errors) {
        rows.push_back({{"to", error.to}, {"error_deg", nullptr}});
        if (!error.error_deg) continue;
        rows.back()["error_deg"] = *error.error_deg;
        sum += std::abs(*error.error_deg);
        worst = std::max(worst, std::abs(*error.error_deg));
        ++measured;
    }
    return {{"measured", measured},
            {"mean_abs_deg", measured > 0 ? ordered_json(sum / static_cast<double>(measured))
                                          : ordered_json(nullptr)},
            {"worst_deg", worst},
            {"steps", rows}};
}

/// The template lies in the frame of the first used capture, the truth in that of the first one.
Pose first_used(const Turns& turns, const Truth& truth) {
    if (turns.T_first_k.empty()) return Pose::Identity();
    return truth.captures.at(turns.T_first_k.begin()->first).T_first_k;
}

Result<ordered_json> measure(const Arguments& arguments) {
    const auto truth = arguments.object ? load_object_truth(arguments.truth_folder)
                                        : load_truth(arguments.truth_folder);
    if (!truth) return forward_error(truth.error());
    const auto points = load_cloud(arguments.template_file);
    if (!points) return forward_error(points.error());
    if (arguments.turns_json.empty()) {
        return json_of(score_template(*points, Pose::Identity(), *truth));
    }
    const auto turns = load_turns(arguments.turns_json, arguments.captures_csv);
    if (!turns) return forward_error(turns.error());
    const Pose T_first_template = first_used(*turns, *truth);
    ordered_json result = json_of(score_template(*points, T_first_template, *truth));
    result["poses"] = json_of(pose_errors(*turns, *truth, T_first_template * centroid(*points)));
    result["turns"] = json_of(step_errors(*turns, *truth));
    return result;
}

}  // namespace
}  // namespace gripscan::test

int main(int argc, char** argv) {
    gripscan::test::Arguments arguments;
    CLI::App app{"Measures a template against the truth of the simulated cell (JSON)"};
    app.add_option("template", arguments.template_file, "PCD, PLY or XYZ")->required();
    app.add_option("truth", arguments.truth_folder, "folder written with --truth")->required();
    app.add_flag("--object", arguments.object, "of the held object alone");
    auto* turns = app.add_option("--turns", arguments.turns_json, "turns.json of the same run");
    auto* captures = app.add_option("--captures", arguments.captures_csv, "its captures.csv");
    turns->needs(captures);
    captures->needs(turns);
    CLI11_PARSE(app, argc, argv);
    const auto result = gripscan::test::measure(arguments);
    if (!result) {
        fmt::print(stderr, "{}\n", result.error().message);
        return 2;
    }
    std::cout << result->dump(1) << "\n";
}
