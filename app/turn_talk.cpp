#include "app/turn_talk.h"

#include "app/console.h"
#include "core/base/number_text.h"

namespace gripscan::app {
namespace {

std::string_view mark(CheckOutcome outcome) {
    switch (outcome) {
        case CheckOutcome::kPassed:
            return "ok  ";
        case CheckOutcome::kWarned:
            return "warn";
        case CheckOutcome::kFailed:
            return "FAIL";
        case CheckOutcome::kSkipped:
            break;
    }
    return "-   ";
}

}  // namespace

void TurnTalk::tell(const ProcedureState& state) {
    if (state.robot && !robot_told_) {
        robot_told_ = true;
        say(context_, fmt::format("{}: {} ({})", word(state.plan.mode), state.robot->model,
                                  state.robot->protocol));
    }
    tell_cell(state);
    if (state.warm_up && !warm_up_told_) {
        warm_up_told_ = true;
        say(context_, "axis: " + state.warm_up->sentence);
    }
    tell_steps(state);
    tell_advice(state);
    for (; rehearsed_told_ < state.rehearsed_joint6_rad.size(); ++rehearsed_told_) {
        say(context_, fmt::format("DRY: would turn joint 6 to {:.3f} deg at {:.0f} %",
                                  deg_from_rad(state.rehearsed_joint6_rad[rehearsed_told_]),
                                  state.plan.speed_percent));
    }
}

void TurnTalk::tell_cell(const ProcedureState& state) {
    if (!state.cell) return;
    for (const CellCheckItem& item : state.cell->items) {
        // Measured again after the warm-up: numbers that passed before need not be told twice.
        const auto told = items_told_.find(item.name);
        const bool passed_twice = told != items_told_.end() &&
                                  told->second.starts_with(mark(CheckOutcome::kPassed)) &&
                                  item.outcome == CheckOutcome::kPassed;
        const std::string line = fmt::format("{} {}", mark(item.outcome), item.sentence);
        if (passed_twice || (told != items_told_.end() && told->second == line)) continue;
        items_told_[item.name] = line;
        say(context_,
            fmt::format("cell check {} {:<11}{}", mark(item.outcome), item.name, item.sentence));
    }
}

void TurnTalk::tell_steps(const ProcedureState& state) {
    for (const JudgedStep& step : table_of(state)) {
        const TurnStep& row = step.row;
        std::string& told = steps_told_[{row.from, row.to}];
        if (told == row.sentence) continue;
        told = row.sentence;
        say(context_, fmt::format("step {} -> {}: {}{}{}: {}", row.from, row.to, word(row.verdict),
                                  row.cause == Cause::kNone ? "" : ", ",
                                  row.cause == Cause::kNone ? "" : word(row.cause), row.sentence));
    }
}

void TurnTalk::tell_advice(const ProcedureState& state) {
    for (; advice_told_ < state.advice.size(); ++advice_told_) {
        const GivenAdvice& given = state.advice[advice_told_];
        // The line has a form that scripts can read: cause and action are words of a list.
        say(context_, fmt::format("advice {} -> {}: cause={} action={}: {}", given.from, given.to,
                                  word(given.advice.cause), word(given.advice.action),
                                  given.advice.sentence));
    }
}

}  // namespace gripscan::app
