#include "tests/tools/pose_score.h"

#include <nlohmann/json.hpp>

#include "core/base/atomic_file.h"
#include "core/base/units.h"
#include "core/session/capture_table.h"

namespace gripscan::test {
namespace {

Turns turns_from(const nlohmann::json& json, const CaptureTable& table) {
    Turns turns;
    for (const auto& step : json.at("steps")) {
        Turns::Step& entry = turns.steps.emplace_back();
        entry.from = step.at("from").get<int>();
        entry.to = step.at("to").get<int>();
        if (!step.at("icp_deg").is_null()) entry.icp_deg = step.at("icp_deg").get<double>();
    }
    for (std::size_t i = 0; i < table.rows.size(); ++i) {
        const auto& numbers = json.at("poses").at(i);
        if (numbers.is_null()) continue;
        turns.T_first_k[table.rows[i].index] =
            pose_from_row_major(numbers.get<std::array<double, 16>>()).value();
    }
    return turns;
}

}  // namespace

Result<Turns> load_turns(const std::filesystem::path& turns_json,
                         const std::filesystem::path& captures_csv) {
    const auto text = read_whole_file(turns_json);
    if (!text) return forward_error(text.error());
    const auto csv = read_whole_file(captures_csv);
    if (!csv) return forward_error(csv.error());
    const auto table = parse_capture_table(captures_csv, *csv);
    if (!table) return forward_error(table.error());
    try {
        return turns_from(nlohmann::json::parse(*text), *table);
    } catch (const std::exception& e) {
        return input_error("{}: {}", turns_json.string(), e.what());
    }
}

std::vector<PoseError> pose_errors(const Turns& turns, const Truth& truth,
                                   const Eigen::Vector3d& centre_m) {
    std::vector<PoseError> errors;
    if (turns.T_first_k.empty()) return errors;
    const int first = turns.T_first_k.begin()->first;
    const Eigen::Vector3d p = truth.axis.nearest_to(centre_m);
    for (const auto& [capture, T_first_k] : turns.T_first_k) {
        const Pose true_T =
            truth.captures.at(first).T_first_k.inverse() * truth.captures.at(capture).T_first_k;
        const Eigen::Matrix3d R = true_T.linear().transpose() * T_first_k.linear();
        errors.push_back({capture, deg_from_rad(rotation_angle_rad(R)),
                          (T_first_k * p - true_T * p).norm() * kMmPerM});
    }
    return errors;
}

std::vector<StepError> step_errors(const Turns& turns, const Truth& truth) {
    std::vector<StepError> errors;
    for (const Turns::Step& step : turns.steps) {
        StepError& error = errors.emplace_back();
        error.to = step.to;
        const double true_deg =
            truth.captures.at(step.to).joint6_deg - truth.captures.at(step.from).joint6_deg;
        if (step.icp_deg) error.error_deg = *step.icp_deg - true_deg;
    }
    return errors;
}

}  // namespace gripscan::test
