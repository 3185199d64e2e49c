#include "core/robot/gsp_exchange.h"

#include <fmt/format.h>

#include "core/robot/command_ids.h"

namespace gripscan::gsp {
namespace {

template <typename... Handlers>
struct Overloaded : Handlers... {
    using Handlers::operator()...;
};
template <typename... Handlers>
Overloaded(Handlers...) -> Overloaded<Handlers...>;

RobotError unknown(RobotFault fault, const TurnRules& rules, const RobotError& why) {
    return {fault, why.code, 0,
            fmt::format("whether turn {} was made is unknown: {}", rules.command.id, why.message)};
}

/// As trouble of the link: a fault after which the motion is unknown.
RobotFault link_fault(const RobotError& error) {
    return error.fault == RobotFault::kTimeout ? RobotFault::kTimeout : RobotFault::kLost;
}

TurnStep lost(int recoveries, const RobotError& why, const TurnRules& rules) {
    if (recoveries >= rules.max_recoveries) {
        return {TurnFailed{unknown(link_fault(why), rules, why)}, TurnAction::kFinish};
    }
    return {TurnLost{recoveries, why}, TurnAction::kRecover};
}

/// A stale id is worth another attempt only with an id above the last one, and above this one:
/// else the caller would ask again and again.
void check_where_to_go_on(RobotError& error, const TurnRules& rules) {
    if (error.last_id < rules.command.id) {
        error.fault = RobotFault::kProtocol;
        error.message += fmt::format("; but it names none of {} or above", rules.command.id);
    } else if (error.last_id >= kGreatestId) {
        error.fault = RobotFault::kRefused;
        error.message += "; but none is left above it: clear the last id on the controller";
    }
}

TurnStep refused(const Failure& failure, const TurnRules& rules) {
    RobotError error = robot_error(failure.code, failure.text);
    if (error.fault == RobotFault::kStaleId) check_where_to_go_on(error, rules);
    return {TurnFailed{std::move(error)}, TurnAction::kFinish};
}

TurnStep unexpected(const TurnState& state) {
    const bool ended =
        std::holds_alternative<TurnDone>(state) || std::holds_alternative<TurnFailed>(state);
    const bool lost = std::holds_alternative<TurnLost>(state);
    return {state,
            ended  ? TurnAction::kFinish
            : lost ? TurnAction::kRecover
                   : TurnAction::kWait,
            false};
}

TurnStep on(const TurnIdle& state, const TurnInput& input, const TurnRules&) {
    if (std::holds_alternative<Begin>(input)) return {TurnSent{}, TurnAction::kSend};
    return unexpected(state);
}

/// Waiting for a reply, before (TurnSent) or after (TurnAccepted) the controller took the command.
template <typename Waiting>
TurnStep on_waiting(const Waiting& state, const TurnInput& input, const TurnRules& rules) {
    constexpr bool kSent = std::is_same_v<Waiting, TurnSent>;
    const int id = rules.command.id;
    const auto on_reply = Overloaded{
        [&](const Accepted& reply) {
            if (!kSent || reply.id != id) return unexpected(state);
            return TurnStep{TurnAccepted{state.recoveries}, TurnAction::kWait};
        },
        [&](const Done& reply) {
            if (reply.id != id) return unexpected(state);
            return TurnStep{TurnDone{reply.position}, TurnAction::kFinish};
        },
        [&](const Failure& reply) {
            // Without an id it tells that the line was not understood: so it was not obeyed, unless
            // an earlier one was.
            if (reply.id == id || (reply.id == 0 && kSent && state.recoveries == 0)) {
                return refused(reply, rules);
            }
            if (reply.id == 0) {
                return lost(state.recoveries, robot_error(reply.code, reply.text), rules);
            }
            return unexpected(state);
        },
        [&](const auto&) { return unexpected(state); },
    };
    return std::visit(
        Overloaded{
            [&](const Reply& reply) { return std::visit(on_reply, reply); },
            [&](const LinkTrouble& now) { return lost(state.recoveries, now.error, rules); },
            [&](const TimeUp& now) { return lost(state.recoveries, now.error, rules); },
            [&](const auto&) { return unexpected(state); },
        },
        input);
}

TurnStep on(const TurnSent& state, const TurnInput& input, const TurnRules& rules) {
    return on_waiting(state, input, rules);
}
TurnStep on(const TurnAccepted& state, const TurnInput& input, const TurnRules& rules) {
    return on_waiting(state, input, rules);
}

TurnStep on(const TurnLost& state, const TurnInput& input, const TurnRules& rules) {
    if (std::holds_alternative<LinkBack>(input)) {
        return {TurnSent{state.recoveries + 1}, TurnAction::kSend};
    }
    if (std::holds_alternative<StandsStill>(input)) {
        const std::string message =
            fmt::format("turn {} was stopped on request while its link was down; read the joint",
                        rules.command.id);
        return {TurnFailed{{RobotFault::kStopped, 0, 0, message}}, TurnAction::kFinish};
    }
    if (std::holds_alternative<GaveUp>(input)) {
        return {TurnFailed{unknown(link_fault(state.why), rules, state.why)}, TurnAction::kFinish};
    }
    return unexpected(state);
}

TurnStep on(const TurnDone& state, const TurnInput&, const TurnRules&) {
    return unexpected(state);
}
TurnStep on(const TurnFailed& state, const TurnInput&, const TurnRules&) {
    return unexpected(state);
}

}  // namespace

TurnStep step(const TurnState& state, const TurnInput& input, const TurnRules& rules) {
    return std::visit([&](const auto& now) { return on(now, input, rules); }, state);
}

}  // namespace gripscan::gsp
