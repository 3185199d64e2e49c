// LIVE, by hand: the arm moves only while a button is held. Holding it begins the next motion,
// letting go stops it. A turn that runs by itself is begun and paused in words; the button is not
// its leash.
#pragma once

#include <optional>
#include <string>

#include "core/procedure/input.h"
#include "core/procedure/procedure_state.h"

namespace gripscan::app {

/// Why a command of the operator has to wait until the button is held; nothing: it may be given.
[[nodiscard]] std::optional<std::string> why_not_held(const ProcedureState& state,
                                                      const Command& command, bool held);

/// What holding the button begins: the next action, where that is a motion of the arm.
[[nodiscard]] std::optional<Command> begun_by_holding(const ProcedureState& state);

/// What letting go asks for: Stop, where a motion that was begun by hand is going on.
[[nodiscard]] std::optional<Command> asked_by_letting_go(const ProcedureState& state);

}  // namespace gripscan::app
