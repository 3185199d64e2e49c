// Who does what the procedure wants done.
#pragma once

#include <stop_token>

#include "core/procedure/effect.h"
#include "core/procedure/procedure_state.h"

namespace gripscan {

class EffectRunner {
  public:
    virtual ~EffectRunner() = default;
    /// Does it, on the engine's worker thread, one at a time, and says how it ended. `state` is the
    /// procedure's as it was when the effect was asked for. Never SaveTable,
    /// SavePlan or Halt.
    [[nodiscard]] virtual Event run(const Effect& effect, const ProcedureState& state,
                                    std::stop_token stop) = 0;
    /// Stops the arm. Called from another thread while run() is going on, whose stop token is then
    /// set too.
    virtual void halt() = 0;
};

}  // namespace gripscan
