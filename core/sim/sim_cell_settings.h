// What a simulated cell can be asked for.
#pragma once

#include "core/sim/sim_cell.h"

namespace gripscan::sim {

/// Names and ranges; the faults are parsed elsewhere. The message says what there is.
[[nodiscard]] Status check(const SimCellSettings& settings);

}  // namespace gripscan::sim
