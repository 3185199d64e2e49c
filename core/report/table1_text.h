// Table 1 for a terminal: aligned columns as in the paper, the sum, closure, axis, and for every
// step that was not accepted one sentence.
#pragma once

#include <string>

#include "core/report/table1.h"

namespace gripscan {

[[nodiscard]] std::string table1_text(const TurnReport& report, const Table1& table);

/// Whether a joint solution closed the turn, and not only the chain of its steps.
[[nodiscard]] bool closed_jointly(const TurnReport& report);

/// "36 of 36 steps accepted; mean |error| 0.08 deg, worst 0.21 deg".
[[nodiscard]] std::string summary_sentence(const TurnReport& report);

}  // namespace gripscan
