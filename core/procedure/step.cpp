#include "core/procedure/step.h"

#include "core/procedure/draft.h"

namespace gripscan {
namespace {

Command advised(const ProcedureState& state, const Advice& advice) {
    switch (advice.action) {
        case AdvisedAction::kRetake:
            return command::Retry{};
        case AdvisedAction::kHalve:
            return command::Halve{};
        case AdvisedAction::kLockAxis:
            return command::LockAxis{};
        case AdvisedAction::kGoOn:
        case AdvisedAction::kStop:
            break;
    }
    return turn_complete(state) ? Command{command::Finish{}} : Command{command::Step{}};
}

std::optional<Command> next_at_rest(const ProcedureState& state) {
    if (!state.cell) return command::CheckCell{};
    if (!state.cell->passed() && state.cell_note.empty()) return command::CheckCell{};
    if (state.plan.mode == MotionMode::kDry) return command::Step{};
    if (state.data.last_used() == nullptr) {
        if (!state.warm_up && state.plan.mode != MotionMode::kManual) return command::WarmUp{};
        return command::Capture{};
    }
    return turn_complete(state) ? Command{command::Finish{}} : Command{command::Step{}};
}

/// Running: the next action is taken as if it had been commanded.
void go_on(Draft& draft) {
    while (draft.state.running) {
        const auto* deciding = std::get_if<phase::Deciding>(&draft.state.phase);
        if (std::holds_alternative<phase::Finished>(draft.state.phase)) {
            draft.state.running = false;
            return;
        }
        if (deciding != nullptr && deciding->advice.action == AdvisedAction::kStop) {
            draft.state.running = false;
            return;
        }
        const auto next = next_action(draft.state);
        const bool at_rest =
            deciding != nullptr || std::holds_alternative<phase::Idle>(draft.state.phase);
        if (!at_rest || !next) return;
        if (refusal(draft.state, *next)) {
            draft.state.running = false;
            return;
        }
        take_command(draft, *next);
    }
}

}  // namespace

std::optional<Command> next_action(const ProcedureState& state) {
    if (std::holds_alternative<phase::Offline>(state.phase)) return command::Connect{};
    if (std::holds_alternative<phase::Interrupted>(state.phase)) return command::Resume{};
    if (const auto* deciding = std::get_if<phase::Deciding>(&state.phase)) {
        if (deciding->advice.action == AdvisedAction::kStop) return std::nullopt;
        return advised(state, deciding->advice);
    }
    if (const auto* busy = std::get_if<phase::Busy>(&state.phase)) {
        if (std::holds_alternative<activity::AwaitingOperator>(busy->activity)) {
            return command::Capture{};
        }
    }
    if (std::holds_alternative<phase::Idle>(state.phase)) return next_at_rest(state);
    return std::nullopt;
}

Transition step(const ProcedureState& state, const Input& input) {
    Draft draft(state);
    if (const auto* command = std::get_if<Command>(&input)) {
        take_command(draft, *command);
    } else {
        take_event(draft, std::get<Event>(input));
    }
    if (draft.refused) return {state, {}, std::move(draft.refused)};
    go_on(draft);
    return {std::move(draft.state), std::move(draft.effects), std::nullopt};
}

}  // namespace gripscan
