// How long steps take, and how long the rest of the turn will.
#pragma once

#include <optional>

#include "core/procedure/procedure_state.h"

namespace gripscan::app {

/// Pure but for the times it is told.
class StepClock {
  public:
    /// The state as it is at that time.
    void tell(const ProcedureState& state, double now_s);
    /// Nothing before the first step was timed, or when the turn is complete.
    [[nodiscard]] std::optional<double> seconds_left(const ProcedureState& state) const;
    /// Since what goes on now began; nothing: it rests.
    [[nodiscard]] std::optional<double> busy_since_s() const { return busy_since_s_; }

  private:
    std::size_t steps_ = 0;
    std::optional<double> last_step_s_;
    double step_takes_s_ = 0.0;  ///< mean of the latest ones; 0: unknown
    std::optional<double> busy_since_s_;
    std::size_t activity_ = 0;
};

}  // namespace gripscan::app
