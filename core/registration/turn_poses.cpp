#include "core/registration/turn_poses.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/base/units.h"
#include "core/registration/axis_lock.h"
#include "core/registration/turn_rows.h"

namespace gripscan {
namespace {

/// What a robot's joint reading is worth, a merely commanded angle, and no angle at all.
constexpr double kReadingSigma_rad = 0.02 * kRadPerDeg;
constexpr double kCommandSigma_rad = 0.05 * kRadPerDeg;
constexpr double kUnknownSigma_rad = 1.0;
/// Of a view that is locked to the axis: its angle is the robot's, and the surfaces have no say.
constexpr double kLockedSigma_rad = 1e-6;

/// The steps from view `first` to view `last`, composed.
Pose composed(const TurnReport& report, std::size_t first, std::size_t last) {
    Pose T = Pose::Identity();
    for (std::size_t i = first; i < last; ++i) {
        if (report.steps[i].T) T = *report.steps[i].T * T;
    }
    return T;
}

std::vector<Pose> chained_poses(const ViewChain& chain, const TurnReport& report) {
    std::vector<Pose> poses;
    for (const std::size_t v : chain.trusted) {
        poses.push_back(composed(report, chain.trusted.front(), v));
    }
    return poses;
}

/// How far a pose is from the nominal turn, and what that does to the axis point.
Closure closure_of(const Pose& T_last_first, const Axis& axis, double nominal_rad) {
    const Pose rest = turn_about(axis, nominal_rad).inverse() * T_last_first;
    return {rotation_angle_rad(rest.linear()), (rest * axis.point_m - axis.point_m).norm()};
}

/// The sum of what was reported, if that is a whole turn to half a step.
std::optional<double> whole_turn_rad(const TurnReport& report, double step_rad) {
    double sum_rad = 0.0;
    for (const TurnStep& step : report.steps) {
        if (!step.T || !reported_rad(step)) return std::nullopt;
        sum_rad += *reported_rad(step);
    }
    const double full_rad = std::copysign(2.0 * std::numbers::pi, sum_rad);
    if (std::abs(sum_rad - full_rad) > 0.5 * std::abs(step_rad)) return std::nullopt;
    return sum_rad;
}

}  // namespace

JointSettings joint_settings(std::span<const CaptureFacts> facts,
                             std::span<const PreparedView* const> views) {
    JointSettings settings;
    const bool held = std::any_of(views.begin(), views.end(),
                                  [](const PreparedView* view) { return view->holder != nullptr; });
    settings.scale_known = held || any_locked(facts);
    return settings;
}

std::vector<JointView> joint_views(std::span<const CaptureFacts> facts,
                                   std::span<const PreparedView* const> views,
                                   std::span<const std::size_t> members,
                                   std::span<const TurnStep> steps) {
    std::vector<JointView> result;
    double angle_rad = 0.0;
    for (std::size_t k = 0; k < members.size(); ++k) {
        const std::size_t v = members[k];
        double sigma_rad = kReadingSigma_rad;
        if (k > 0) {
            const std::size_t before = members[k - 1];
            const auto joint = difference(joint6_rad(facts[before]), joint6_rad(facts[v]));
            const auto command = difference(facts[before].commanded_rad, facts[v].commanded_rad);
            if (joint || command) {
                angle_rad += joint ? *joint : *command;
                if (!joint) sigma_rad = kCommandSigma_rad;
                if (facts[v].mode == TurnMode::kAxisLocked) sigma_rad = kLockedSigma_rad;
            } else {
                for (std::size_t i = before; i < std::min(v, steps.size()); ++i) {
                    angle_rad += steps[i].icp_rad.value_or(0.0);
                }
                sigma_rad = kUnknownSigma_rad;
            }
        }
        result.push_back({&views[v]->surface, angle_rad, sigma_rad});
    }
    return result;
}

Status solve_poses(std::span<const CaptureFacts> facts, std::span<const PreparedView* const> views,
                   const ViewChain& chain, const TurnSettings& settings, const Progress& progress,
                   const ForEach& for_each, TurnReport& report) {
    std::vector<Pose> T_view_chain = chained_poses(chain, report);
    const bool jointly =
        settings.method == TurnMethod::kTurn && report.axis && chain.trusted.size() > 2;
    if (jointly) {
        auto solution = solve_jointly(joint_views(facts, views, chain.trusted, report.steps),
                                      report.axis->axis, joint_settings(facts, views), progress, for_each);
        if (!solution) return forward_error(std::move(solution.error()));
        report.axis = solution->axis;
        if (solution->scale_estimated) report.angle_scale = solution->scale;
        T_view_chain = std::move(solution->T_view_first);
    }
    // The first used capture may itself be in doubt: then its own steps link it to the others.
    const Pose T_chain_first = composed(report, 0, chain.trusted.front());
    report.poses.assign(views.size(), std::nullopt);
    for (std::size_t k = 0; k < chain.trusted.size(); ++k) {
        report.poses[chain.trusted[k]] = (T_view_chain[k] * T_chain_first).inverse();
    }
    return {};
}

bool spans_whole_turn(double step_rad, const TurnReport& report) {
    return whole_turn_rad(report, step_rad).has_value();
}

void set_closures(double step_rad, TurnReport& report) {
    const auto nominal_rad = whole_turn_rad(report, step_rad);
    const bool measured =
        std::none_of(report.steps.begin(), report.steps.end(),
                     [](const TurnStep& step) { return step.mode == TurnMode::kAxisLocked; });
    if (!report.axis || !nominal_rad || !measured) return;
    const Axis& axis = report.axis->axis;
    report.closure_before =
        closure_of(composed(report, 0, report.steps.size()), axis, *nominal_rad);
    report.closure_after = report.closure_before;
    if (report.poses.back()) {
        report.closure_after = closure_of(report.poses.back()->inverse(), axis, *nominal_rad);
    }
}

}  // namespace gripscan
