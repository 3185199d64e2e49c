// The cell check: every prerequisite of a turn as a number against a limit, before the first step
// and, with what only a warm-up can show, after it.
#pragma once

#include "core/procedure/cell_facts.h"
#include "core/procedure/cell_limits.h"
#include "core/procedure/cell_report.h"
#include "core/procedure/turn_plan.h"

namespace gripscan {

/// Pure. All items of the table in cell_limits.h, in its order; what is not known is skipped, with
/// the reason.
[[nodiscard]] CellReport assess(const CellFacts& facts, const TurnPlan& plan,
                                const CellLimits& limits = {});

}  // namespace gripscan
