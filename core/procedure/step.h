// The procedure as one pure function: a state and an input give the next state and what is to be
// done. An input that makes no sense in a phase changes nothing and says why.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/procedure/effect.h"
#include "core/procedure/procedure_state.h"

namespace gripscan {

struct Transition {
    ProcedureState state;
    std::vector<Effect> effects;
    std::optional<std::string> refused;  ///< why the input was not taken; then nothing has changed
};

[[nodiscard]] Transition step(const ProcedureState& state, const Input& input);

/// Why a command would be refused now; nothing: it may be given. What buttons are greyed by.
[[nodiscard]] std::optional<std::string> refusal(const ProcedureState& state,
                                                 const Command& command);

/// What the operator is expected to do next; nothing while something is going on.
[[nodiscard]] std::optional<Command> next_action(const ProcedureState& state);

}  // namespace gripscan
