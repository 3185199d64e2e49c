#include "ui/views/step_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/units.h"
#include "core/procedure/remedy.h"
#include "core/procedure/step.h"
#include "core/registration/quality.h"
#include "core/registration/turn_check.h"
#include "ui/theme/shown_number.h"
#include "ui/views/activity_text.h"
#include "ui/views/cell_view.h"
#include "ui/views/sentences.h"
#include "ui/views/status_text.h"

namespace gripscan::ui {
namespace {

std::string degrees(double rad, int decimals = 3, Sign sign = Sign::kMinusOnly) {
    return shown_number(deg_from_rad(rad), decimals, sign) + "°";
}

bool shows_last(const Snapshot& s) {
    const auto rows = table_of(*s.procedure).size();
    return s.follows_last || s.selected_row + 1 >= rows;
}

/// What the rows up to and with the shown one add up to.
struct Sums {
    double robot_rad = 0.0;
    double icp_rad = 0.0;
    double variance_rad2 = 0.0;
    bool complete = true;  ///< every row has both angles, one measured against the other
};
Sums sums_to(const std::vector<JudgedStep>& rows, int last_index) {
    Sums sums;
    for (const JudgedStep& step : rows) {
        if (step.row.index > last_index) break;
        sums.complete =
            sums.complete && step.row.robot_rad && step.row.icp_rad && step.row.error_rad;
        sums.robot_rad += step.row.robot_rad.value_or(0.0);
        sums.icp_rad += step.row.icp_rad.value_or(0.0);
        sums.variance_rad2 += std::pow(step.row.sigma_rad.value_or(0.0), 2);
    }
    return sums;
}

HeadingLine icp_sum(const Sums& sums) {
    if (!sums.complete) return {"ICP sum", "–", {}};
    return {"ICP sum", degrees(sums.icp_rad),
            degrees(sums.icp_rad - sums.robot_rad, 3, Sign::kAlways)};
}

StepHeading heading_before_steps(const ProcedureState& state) {
    StepHeading heading;
    if (std::holds_alternative<phase::Offline>(state.phase)) {
        heading.title = "Not connected";
    } else if (std::holds_alternative<phase::Connecting>(state.phase)) {
        heading.title = "Connecting";
    } else if (state.data.last_used() != nullptr) {
        heading.title = "First view";
    } else if (!state.cell) {
        heading.title = "Cell check";
    } else {
        const bool warms_up = state.plan.mode != MotionMode::kManual && !state.warm_up;
        heading.title = warms_up ? "Axis warm-up" : "First view";
    }
    heading.lines = {
        {"Plan", fmt::format("{} × {}", steps_planned(state), degrees(state.data.step_rad, 1)), {}},
        {"J6 speed", fmt::format("{:.0f} %", state.plan.speed_percent), {}},
        {"Angle limit", "±" + degrees(state.plan.limits.angle_rad), {}}};
    return heading;
}

StepHeading heading_of_finished(const Snapshot& s, const std::vector<JudgedStep>& rows) {
    StepHeading heading{"Finished", fmt::format("{} steps", rows.size()), {}};
    const Sums sums = sums_to(rows, static_cast<int>(rows.size()));
    heading.lines = {{"Robot sum", degrees(sums.robot_rad), {}},
                     icp_sum(sums)};
    if (!s.solved) return heading;
    const auto closure = [&](std::string_view label, const std::optional<Closure>& c) {
        if (!c) return;
        heading.lines.push_back(
            {label, degrees(c->angle_rad, 2), shown_number(kMmPerM * c->shift_m, 2) + " mm"});
    };
    closure("Closure", s.solved->report.closure_before);
    closure("Solved", s.solved->report.closure_after);
    return heading;
}

std::string angle_sentence(const TurnStep& row, const TurnLimits& limits) {
    const double reported_rad = *row.icp_rad - *row.error_rad;
    const double limit_rad = angle_limit_rad(row, limits);
    const std::string sides =
        fmt::format("ICP turned `{}`, {} `{}`: error `{}`", degrees(*row.icp_rad),
                    row.robot_rad ? "the robot" : "the plan says", degrees(reported_rad),
                    degrees(*row.error_rad, 3, Sign::kAlways));
    const bool inside = std::abs(*row.error_rad) <= limit_rad;
    return fmt::format("{}{} `±{}`.", sides, inside ? " is inside the limit of" : ", limit",
                       degrees(limit_rad));
}

VerdictWords verdict_of_step(const JudgedStep& step, const TurnLimits& limits) {
    const TurnStep& row = step.row;
    VerdictWords words;
    words.state = state_of(row.verdict);
    if (row.verdict == Verdict::kAcceptNoted) words.word = "Accepted with note";
    words.basis = capitalised(word(row.mode));
    words.basis += row.independent ? ", independent" : ", not independent";
    const bool angle_tells = row.icp_rad && row.error_rad &&
                             (row.verdict == Verdict::kAccept ||
                              std::abs(*row.error_rad) > angle_limit_rad(row, limits)) &&
                             row.verdict != Verdict::kAcceptNoted;
    words.sentence = angle_tells ? angle_sentence(row, limits) : shown_sentence(row.sentence);
    return words;
}

VerdictWords verdict_before_steps(const ProcedureState& state) {
    if (const auto* offline = std::get_if<phase::Offline>(&state.phase)) {
        if (!offline->why.empty()) {
            return {State::kReject, "No link", {}, false, shown_sentence(offline->why)};
        }
        return {State::kWaiting,
                "Not connected",
                {},
                false,
                "Connect opens the link to robot and camera. Nothing moves yet."};
    }
    if (!state.cell) {
        return {State::kWaiting,
                "Cell not checked",
                {},
                false,
                "The cell check measures every prerequisite of a turn. Nothing moves yet."};
    }
    for (const CellCheckItem& item : state.cell->items) {
        if (item.outcome != CheckOutcome::kFailed || !state.cell_note.empty()) continue;
        return {State::kReject, "Cell check failed", item.name, false,
                shown_sentence(item.sentence)};
    }
    if (state.data.last_used() != nullptr) {
        return {State::kAccept,
                "First view taken",
                {},
                false,
                "The turn can begin: every step is compared with the robot."};
    }
    if (state.warm_up) {
        return {state.warm_up->axis ? State::kAccept : State::kCheck,
                state.warm_up->axis ? "Axis found" : "Axis not shown",
                {},
                false,
                shown_sentence(state.warm_up->sentence)};
    }
    return {State::kAccept,
            "Cell is ready",
            {},
            false,
            state.plan.mode == MotionMode::kManual
                ? "Take the first view, then turn joint 6 from view to view."
                : "Small turns of joint 6 show where its axis lies."};
}

EvidenceText with_state(EvidenceText e) {
    if (!std::isfinite(e.limit) || !std::isfinite(e.value)) {
        e.state = State::kWaiting;
        return e;
    }
    const double size = std::abs(e.value);
    e.excess = e.at_least ? e.limit / std::max(size, 1e-9) : size / e.limit;
    e.state = e.excess <= 1.0           ? State::kAccept
              : e.excess < kCheckFactor ? State::kCheck
                                        : State::kReject;
    return e;
}

constexpr double kNoLimit = std::numeric_limits<double>::quiet_NaN();

std::vector<EvidenceText> rows_of(const TurnStep& row, const TurnLimits& limits) {
    const auto or_nothing = [](const std::optional<double>& value, double scale) {
        return value ? *value * scale : kNoLimit;
    };
    std::vector<EvidenceText> rows{
        {"evidence.angle_error", "Angle error", or_nothing(row.error_rad, kDegPerRad), "°", 3, true,
         deg_from_rad(angle_limit_rad(row, limits)), 3, false, State::kAccept,
         "ICP angle minus robot angle about joint 6. The limit is the plan's, or three sigma of "
         "the "
         "ICP angle where that is more."},
        {"evidence.axis_tilt", "Axis tilt", or_nothing(row.tilt_rad, kDegPerRad), "°", 3, false,
         deg_from_rad(limits.tilt_rad), 3, false, State::kAccept,
         "Angle between the axis of this step and the axis of all accepted steps."},
        {"evidence.axis_offset", "Axis offset", or_nothing(row.axis_offset_m, kMmPerM), "mm", 2,
         false, kNoLimit, 2, false, State::kAccept,
         "Distance of the two axes at the middle of the gripper. It has no limit of its own."},
        {"evidence.slip", "Slip along axis", or_nothing(row.slip_m, kMmPerM), "mm", 2, true,
         kMmPerM * limits.slip_m, 2, false, State::kAccept,
         "Shift along the axis of joint 6, which no turn makes."},
        {"evidence.overlap", "Overlap", or_nothing(row.overlap, 100.0), "%", 0, false,
         100.0 * limits.overlap, 0, true, State::kAccept,
         "Share of the surface that both views see, after alignment."},
        {"evidence.rms", "Residual RMS", or_nothing(row.rms_m, kMmPerM), "mm", 2, false, kNoLimit,
         2, false, State::kAccept,
         "Distance of matched points along the normal. Small also where a surface hides its turn: "
         "it has no limit of its own."},
        {"evidence.axis_information",
         "Axis information",
         or_nothing(row.observability, 1.0),
         {},
         2,
         false,
         kLeastObservability,
         2,
         true,
         State::kAccept,
         "How much the surface resists a turn about the axis: 0 for a surface of revolution, near "
         "0.5 for a cube."}};
    for (EvidenceText& e : rows) e = with_state(e);
    return rows;
}

/// The limits that a plan sets, before there is a step that they judge.
std::vector<EvidenceText> limits_ahead(const Snapshot& s) {
    if (s.procedure == nullptr || !s.procedure->data.captures.empty()) return {};
    auto rows = rows_of(TurnStep{}, s.procedure->plan.limits);
    std::erase_if(rows, [](const EvidenceText& e) { return limit_fields(e.id).empty(); });
    return rows;
}

}  // namespace

std::optional<JudgedStep> shown_step(const Snapshot& s) {
    if (s.procedure == nullptr) return std::nullopt;
    const auto rows = table_of(*s.procedure);
    if (rows.empty()) return std::nullopt;
    return s.follows_last ? rows.back() : rows[std::min(s.selected_row, rows.size() - 1)];
}

int steps_planned(const ProcedureState& state) {
    const double step_rad = state.data.step_rad > 0.0 ? state.data.step_rad : state.plan.step_rad;
    const auto used = state.data.used();
    const CaptureRecord* last = state.data.last_used();
    const double left_rad = state.plan.total_rad - (last != nullptr ? last->commanded_rad : 0.0);
    const int taken = used.empty() ? 0 : static_cast<int>(used.size()) - 1;
    return taken + static_cast<int>(std::ceil(std::max(0.0, left_rad) / step_rad - 1e-3));
}

State state_of(Verdict verdict) {
    switch (verdict) {
        case Verdict::kCheck:
            return State::kCheck;
        case Verdict::kReject:
            return State::kReject;
        case Verdict::kAccept:
        case Verdict::kAcceptNoted:
            break;
    }
    return State::kAccept;
}

DialText dial_of(const Snapshot& s) {
    DialText dial;
    if (s.procedure == nullptr) return dial;
    const ProcedureState& state = *s.procedure;
    dial.whole_deg = deg_from_rad(state.plan.total_rad);
    const auto used = state.data.used();
    if (used.empty()) return dial;
    const CaptureRecord& first = state.data.captures[used.front()];
    const CaptureRecord& last = state.data.captures[used.back()];
    const auto rows = table_of(state);
    // A view that is not compared yet has not turned anything.
    const CaptureRecord* compared = rows.empty() ? &first : state.data.find(rows.back().row.to);
    double turned_rad = compared != nullptr ? compared->commanded_rad : last.commanded_rad;
    if (!rows.empty() && rows.back().row.verdict == Verdict::kReject) {
        const double refused_rad = rows.back().row.commanded_rad.value_or(0.0);
        dial.refused_deg = deg_from_rad(refused_rad);
        turned_rad -= refused_rad;
    } else if (!turn_complete(state)) {
        dial.next_deg =
            deg_from_rad(std::min(state.data.step_rad, state.plan.total_rad - turned_rad));
    }
    dial.turned_deg = deg_from_rad(turned_rad);
    dial.robot_deg = deg_from_rad(last.commanded_rad);
    const auto standing_rad = standing_joint6_rad(state);
    if (standing_rad && first.before) {
        dial.robot_deg = deg_from_rad(*standing_rad - first.before->joints_rad[5]);
    }
    return dial;
}

StepHeading heading_of(const Snapshot& s) {
    if (s.procedure == nullptr) return {};
    const ProcedureState& state = *s.procedure;
    const auto step = shown_step(s);
    if (!step) return heading_before_steps(state);
    const auto rows = table_of(state);
    if (std::holds_alternative<phase::Finished>(state.phase) && s.follows_last) {
        return heading_of_finished(s, rows);
    }
    const TurnStep& row = step->row;
    StepHeading heading{
        fmt::format("Step {}", row.index), fmt::format("of {}", steps_planned(state)), {}};
    const Sums sums = sums_to(rows, row.index);
    if (row.verdict == Verdict::kReject) {
        const double from_rad = sums.robot_rad - row.robot_rad.value_or(0.0);
        heading.lines = {
            {"Robot", fmt::format("{} → {}", degrees(from_rad), degrees(sums.robot_rad)), {}},
            {"Attempt", fmt::format("{}", row.attempts), "nothing merged"}};
        return heading;
    }
    heading.lines.push_back({"Robot sum", degrees(sums.robot_rad), {}});
    heading.lines.push_back(icp_sum(sums));
    heading.lines.push_back({"Expected", "±" + degrees(std::sqrt(sums.variance_rad2)), "1 σ"});
    heading.lines.push_back(
        {"Time left", s.seconds_left ? duration_text(*s.seconds_left) : "–", {}});
    return heading;
}

VerdictWords verdict_of(const Snapshot& s) {
    if (s.procedure == nullptr) return {};
    const ProcedureState& state = *s.procedure;
    if (shows_last(s)) {
        if (const auto* interrupted = std::get_if<phase::Interrupted>(&state.phase)) {
            return {State::kCheck, "Interrupted", std::string(activity_word(interrupted->activity)),
                    false, shown_sentence(interrupted->why)};
        }
        if (std::holds_alternative<phase::Connecting>(state.phase)) {
            return {State::kRunning,
                    "Connecting",
                    {},
                    false,
                    "The link to robot and camera is opened."};
        }
        if (const Activity* activity = activity_of(state)) {
            const bool halting = std::holds_alternative<phase::Halting>(state.phase);
            return {State::kRunning, halting ? "Stopping" : std::string(activity_word(*activity)),
                    s.job ? fmt::format("{:.1f} s", s.job->elapsed_s) : std::string(), true,
                    activity_sentence(*activity)};
        }
    }
    if (const auto step = shown_step(s)) return verdict_of_step(*step, state.plan.limits);
    return verdict_before_steps(state);
}

std::optional<CauseText> cause_of(const Snapshot& s) {
    const auto step = shown_step(s);
    if (!step || state_of(step->row.verdict) == State::kAccept) return std::nullopt;
    CauseText text{capitalised(remedy_for(step->row.cause).what_is_wrong), {}};
    for (const GivenAdvice& given : s.procedure->advice) {
        if (given.from == step->row.from && given.to == step->row.to) {
            text.advice = shown_sentence(given.advice.sentence);
        }
    }
    return text;
}

std::vector<EvidenceText> evidence_rows(const Snapshot& s) {
    const auto step = shown_step(s);
    if (!step) return limits_ahead(s);
    auto rows = rows_of(step->row, s.procedure->plan.limits);
    if (step->row.verdict == Verdict::kReject) {
        std::stable_sort(
            rows.begin(), rows.end(),
            [](const EvidenceText& a, const EvidenceText& b) { return a.excess > b.excess; });
    }
    return rows;
}

EvidenceCaption evidence_caption(const Snapshot& s) {
    if (s.procedure == nullptr) return {};
    const auto step = shown_step(s);
    if (!step) return {"Limits of every step", false};
    const Activity* activity = activity_of(*s.procedure);
    if (activity == nullptr || !shows_last(s)) return {};
    const int index = step->row.index;
    if (std::holds_alternative<activity::Solving>(*activity)) {
        return {fmt::format("Step {}, the last one", index), true};
    }
    return {fmt::format("Step {}, the one before", index), true};
}

ToldAngle told_angle_of(const Snapshot& s) {
    ToldAngle told{"J6 as the pendant shows it", kNoLimit, "no session is open"};
    if (s.procedure == nullptr) return told;
    if (const auto joint6_rad = standing_joint6_rad(*s.procedure)) {
        told.joint6_deg = deg_from_rad(*joint6_rad);
    }
    if (s.session && s.session->recorded) {
        told.why_not = "a recording is only looked at";
    } else {
        told.why_not = refusal(*s.procedure, command::TellAngle{}).value_or(std::string());
    }
    return told;
}

std::string why_step_waits(const Snapshot& s) {
    if (!s.session || s.procedure == nullptr) return "No session is open.";
    if (s.session->recorded) return "A recording is shown: nothing is moved or captured.";
    const ProcedureState& state = *s.procedure;
    if (const auto* deciding = std::get_if<phase::Deciding>(&state.phase)) {
        const auto step = shown_step(s);
        const int index = step ? static_cast<int>(table_of(state).size()) : 0;
        if (deciding->advice.action != AdvisedAction::kGoOn) {
            return fmt::format("Step {} is to be accepted or taken again.", index);
        }
    }
    const auto why = refusal(state, command::Step{});
    return why ? "Step waits: " + *why + "." : std::string();
}

}  // namespace gripscan::ui
