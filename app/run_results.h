// What a run ends with: the results in the session folder, and what is printed of them.
#pragma once

#include <filesystem>
#include <optional>

#include "app/context.h"
#include "app/turn_options.h"
#include "app/turn_work.h"
#include "core/procedure/cell_effects.h"
#include "core/procedure/procedure_state.h"

namespace gripscan::app {

class RunResults : public ResultKeeper {
  public:
    RunResults(std::filesystem::path session, TurnOptions options)
        : session_(std::move(session)), options_(std::move(options)) {}

    /// Writes SESSION/results as a whole.
    [[nodiscard]] Status keep(const ComputedTurn& turn) override;

    /// Prints table or JSON. A turn that was not completed is never trusted. Results of an earlier
    /// process are computed again.
    [[nodiscard]] Result<ExitStatus> deliver(bool complete, const Context& context) const;

  private:
    std::filesystem::path session_;
    TurnOptions options_;
    std::optional<TurnWork> work_;
};

/// DRY: the cell check and the motions that were not sent (gripscan-rehearsal/1).
void tell_rehearsal(const ProcedureState& state, const Context& context);
/// No turn could be made: the cell check (gripscan-cell-check/1).
void tell_refusal(const ProcedureState& state, const Context& context);

}  // namespace gripscan::app
