#include "app/workstation/hold_to_move.h"

#include "core/procedure/step.h"

namespace gripscan::app {
namespace {

/// A motion is going on, or will be sent once what goes on has ended.
bool moving(const ProcedureState& state) {
    const auto* busy = std::get_if<phase::Busy>(&state.phase);
    return busy != nullptr && std::holds_alternative<activity::Moving>(busy->activity);
}

bool by_hand(const ProcedureState& state) {
    return state.plan.mode == MotionMode::kLive && !state.running;
}

bool begins_motion(const ProcedureState& state, const Command& command) {
    const Transition next = step(state, Input{command});
    return !next.refused && !next.state.running && moving(next.state) && !moving(state);
}

}  // namespace

std::optional<std::string> why_not_held(const ProcedureState& state, const Command& command,
                                        bool held) {
    if (held || !by_hand(state) || !begins_motion(state, command)) return std::nullopt;
    return "it moves the arm: hold `Hold to move`, or press it while that is held";
}

std::optional<Command> begun_by_holding(const ProcedureState& state) {
    if (!by_hand(state)) return std::nullopt;
    auto next = next_action(state);
    return next && begins_motion(state, *next) ? next : std::nullopt;
}

std::optional<Command> asked_by_letting_go(const ProcedureState& state) {
    if (!by_hand(state) || !moving(state)) return std::nullopt;
    return command::Stop{};
}

}  // namespace gripscan::app
