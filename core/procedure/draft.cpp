#include "core/procedure/draft.h"

#include <algorithm>
#include <cmath>

#include "core/procedure/motion_plan.h"
#include "core/robot/kinematics.h"

namespace gripscan {
namespace {

constexpr double kSameAngle_rad = 1e-7;

struct EffectOf {
    Effect operator()(const activity::CheckingCell&) const { return effect::MeasureCell{}; }
    Effect operator()(const activity::Moving& a) const { return effect::Turn{a.command}; }
    Effect operator()(const activity::Exposing& a) const { return effect::Expose{a.shot}; }
    Effect operator()(const activity::Judging& a) const { return effect::Judge{a.from, a.to}; }
    Effect operator()(const activity::EstimatingAxis&) const { return effect::EstimateAxis{}; }
    Effect operator()(const activity::Solving&) const { return effect::Solve{}; }
    Effect operator()(const activity::AwaitingOperator&) const { return effect::SaveTable{}; }
};

/// A motion along these angles, of which there is one at least. Its command has neither id nor
/// speed yet.
activity::Moving along(std::vector<double> way, const std::optional<Shot>& shot) {
    activity::Moving moving;
    moving.command.angle_rad = way.front();
    moving.then_rad.assign(way.begin() + 1, way.end());
    moving.shot = shot;
    return moving;
}

}  // namespace

bool same_angle(double a_rad, double b_rad) {
    return std::abs(a_rad - b_rad) < kSameAngle_rad;
}

void Draft::begin(Activity activity) {
    // The operator is waited for, nothing has to be done for that.
    if (!std::holds_alternative<activity::AwaitingOperator>(activity)) {
        effects.push_back(std::visit(EffectOf{}, activity));
    }
    state.phase = phase::Busy{std::move(activity)};
}

void Draft::send(std::vector<double> way, const std::optional<Shot>& shot) {
    activity::Moving moving = along(std::move(way), shot);
    moving.command.id = state.next_motion_id++;
    moving.command.speed_percent = state.plan.speed_percent;
    begin(std::move(moving));
}

std::vector<double> Draft::way_from(double from_rad, double to_rad) const {
    return way_to(
        to_rad, from_rad,
        {state.plan.approach_rad, state.plan.largest_move_rad, joint_ranges()[5].min_rad});
}

void Draft::log_way_to(double joint6_rad) {
    const auto& logged = state.rehearsed_joint6_rad;
    const double start_rad = joint6_of(0.0);
    std::vector<double> way;
    if (logged.empty()) way = way_from(standing_joint6_rad(state).value_or(start_rad), start_rad);
    const auto on = way_from(logged.empty() ? start_rad : logged.back(), joint6_rad);
    way.insert(way.end(), on.begin(), on.end());
    effects.emplace_back(effect::LogTurn{});
    state.phase = phase::Busy{along(std::move(way), std::nullopt)};
}

void Draft::drive_to(double joint6_rad, const std::optional<Shot>& shot) {
    if (state.plan.mode == MotionMode::kDry) return log_way_to(joint6_rad);
    const auto standing = standing_joint6_rad(state);
    if (state.plan.mode == MotionMode::kManual) {
        if (shot) begin(activity::AwaitingOperator{joint6_rad, *shot});
        return;
    }
    auto way = way_from(standing.value_or(joint6_rad), joint6_rad);
    if (way.empty()) {
        if (!shot) return rest();
        return begin(activity::Exposing{*shot});
    }
    send(std::move(way), shot);
}

void Draft::shoot(const Shot& shot) {
    drive_to(joint6_of(shot.commanded_rad), shot);
}

void Draft::shoot_from_below(const Shot& shot) {
    const TurnPlan& plan = state.plan;
    const double target_rad = joint6_of(shot.commanded_rad);
    const double below_rad = target_rad - plan.approach_rad;
    const bool moves = plan.mode == MotionMode::kSim || plan.mode == MotionMode::kLive;
    const auto standing_rad = standing_joint6_rad(state);
    const bool there = standing_rad && stands_at(*standing_rad, target_rad);
    const bool wanted = approaches_anew() && below_rad >= joint_ranges()[5].min_rad;
    if (!moves || !there || !wanted) return shoot(shot);
    send({below_rad, target_rad}, shot);
}

bool Draft::approaches_anew() const {
    return state.plan.warm_up_in_place.has_value();
}

bool Draft::may_be_under_way(const activity::Moving& moving) const {
    if (moving.command.id == 0) return false;
    const auto standing_rad = standing_joint6_rad(state);
    if (!standing_rad || !approaches_anew()) return true;
    const double left_rad = std::abs(moving.command.angle_rad - *standing_rad);
    return left_rad < state.plan.largest_move_rad + rad_from_deg(0.1);
}

void Draft::begin_again(const Activity& activity) {
    if (const auto* moving = std::get_if<activity::Moving>(&activity)) {
        // An id whose end is unknown is asked for again: the controller never turns twice for it.
        if (may_be_under_way(*moving)) return begin(*moving);
        if (moving->shot) return shoot_from_below(*moving->shot);
        return drive_to(moving->target_rad(), moving->shot);
    }
    // The cell may have been started anew since, and stand at its home.
    if (const auto* exposing = std::get_if<activity::Exposing>(&activity)) {
        return shoot_from_below(exposing->shot);
    }
    begin(activity);
}

void Draft::remember() {
    if (state.undo.empty() || !(state.undo.back() == state.data)) {
        state.undo.push_back(state.data);
    }
    state.redo.clear();
}

void Draft::data_changed() {
    effects.emplace_back(effect::SaveTable{});
    state.solved.reset();
    judge_next();
}

void Draft::judge_next() {
    const auto used = state.data.used();
    for (std::size_t i = 1; i < used.size(); ++i) {
        const int from = state.data.captures[used[i - 1]].index;
        const int to = state.data.captures[used[i]].index;
        if (state.judged.find({from, to}) == state.judged.end()) {
            return begin(activity::Judging{from, to});
        }
    }
    rest();
}

void Draft::rest() {
    if (state.solved) {
        state.phase = phase::Finished{};
        return;
    }
    const auto table = table_of(state);
    if (table.empty() || trusted(table.back().row)) {
        state.phase = phase::Idle{};
        return;
    }
    const TurnStep& row = table.back().row;
    const GivenAdvice given{row.from, row.to, advice_for(state)};
    if (state.advice.empty() || !(state.advice.back() == given)) state.advice.push_back(given);
    state.phase = phase::Deciding{given.advice};
}

void Draft::forget_judged(int index) {
    std::erase_if(state.judged, [&](const auto& entry) {
        return entry.first.first == index || entry.first.second == index;
    });
}

void Draft::settle_start() {
    state.plan.start_joint6_rad =
        start_of_turn(state.plan, standing_joint6_rad(state).value_or(0.0));
}

double Draft::joint6_of(double commanded_rad) const {
    return state.plan.start_joint6_rad.value_or(0.0) + commanded_rad;
}

Shot Draft::shot_at(double commanded_rad) const {
    const auto& captures = state.data.captures;
    const auto tried = std::count_if(captures.begin(), captures.end(), [&](const auto& c) {
        return same_angle(c.commanded_rad, commanded_rad);
    });
    return {ShotPurpose::kTurn, state.data.next_index(), static_cast<int>(tried) + 1,
            commanded_rad};
}

double Draft::start_of_warm_up() const {
    const TurnPlan& plan = state.plan;
    if (!plan.warm_up_in_place.value_or(false)) return joint6_of(0.0);
    const double standing_rad = standing_joint6_rad(state).value_or(joint6_of(0.0));
    const double length_rad = (plan.warm_up_shots - 1) * plan.warm_up_step_rad;
    if (const auto& begun_rad = state.warm_up_joint6_rad) {
        const bool among_them = standing_rad > *begun_rad - 2.0 * plan.approach_rad &&
                                standing_rad < *begun_rad + length_rad + plan.approach_rad;
        if (among_them) return *begun_rad;
    }
    const auto [min_rad, max_rad] = joint_ranges()[5];
    return std::clamp(standing_rad, min_rad, max_rad - length_rad);
}

Shot Draft::warm_up_shot() const {
    const int number = state.warm_up_shots;
    const double first_rad = state.warm_up_joint6_rad.value_or(joint6_of(0.0)) - joint6_of(0.0);
    return {ShotPurpose::kWarmUp, -1 - number, 1, first_rad + number * state.plan.warm_up_step_rad};
}

}  // namespace gripscan
