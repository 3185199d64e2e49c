// What a run without a window tells while it goes on: each event of the procedure once, in a line.
#pragma once

#include "app/context.h"
#include "core/procedure/procedure_state.h"

namespace gripscan::app {

class TurnTalk {
  public:
    explicit TurnTalk(const Context& context) : context_(context) {}
    /// Tells what is new since the last call.
    void tell(const ProcedureState& state);

  private:
    void tell_cell(const ProcedureState& state);
    void tell_steps(const ProcedureState& state);
    void tell_advice(const ProcedureState& state);

    const Context& context_;
    bool robot_told_ = false;
    std::map<std::string, std::string> items_told_;  ///< the sentence of each
    bool warm_up_told_ = false;
    std::map<std::pair<int, int>, std::string> steps_told_;  ///< the sentence of each
    std::size_t advice_told_ = 0;
    std::size_t rehearsed_told_ = 0;
};

}  // namespace gripscan::app
