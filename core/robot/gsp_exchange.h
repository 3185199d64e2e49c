// One turn of joint 6 from the PC's side, as a state machine without sockets or clocks: what comes
// in, what to do next. Whatever gets lost, the same id is asked again, never another.
#pragma once

#include <variant>

#include "core/robot/gsp_message.h"

namespace gripscan::gsp {

// States.

struct TurnIdle {};
/// Sent, no answer yet. `recoveries`: how often the link had to be found again so far.
struct TurnSent {
    int recoveries = 0;
};
/// The controller has taken it.
struct TurnAccepted {
    int recoveries = 0;
};
/// No usable link: whether the joint moves is unknown.
struct TurnLost {
    int recoveries = 0;
    RobotError why;
};
struct TurnDone {
    Position position;
};
struct TurnFailed {
    RobotError error;
};
using TurnState = std::variant<TurnIdle, TurnSent, TurnAccepted, TurnLost, TurnDone, TurnFailed>;

// What happens; also any Reply.

struct Begin {};
/// The connection went, or brought something that makes no sense.
struct LinkTrouble {
    RobotError error;
};
/// The limit of the state is over.
struct TimeUp {
    RobotError error;
};
/// Connected again, and the position was read.
struct LinkBack {};
/// Connected again after a stop request: the controller stopped, and the arm stands still.
struct StandsStill {};
/// The link did not come back in time.
struct GaveUp {};
using TurnInput = std::variant<Begin, Reply, LinkTrouble, TimeUp, LinkBack, StandsStill, GaveUp>;

enum class TurnAction {
    kWait,     ///< for a reply
    kSend,     ///< the command
    kRecover,  ///< find the link again, read the position
    kFinish,   ///< nothing is left to do
};

struct TurnStep {
    TurnState state;
    TurnAction action = TurnAction::kWait;
    bool expected = true;  ///< false: the input has no meaning in that state and changed nothing
};

struct TurnRules {
    TurnJoint6 command;
    int max_recoveries = 3;
};

[[nodiscard]] TurnStep step(const TurnState& state, const TurnInput& input, const TurnRules& rules);

}  // namespace gripscan::gsp
