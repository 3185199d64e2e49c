// The numbers of a row against their limits, as lines to show beside an advice.
#pragma once

#include <string>
#include <vector>

#include "core/procedure/judged_step.h"

namespace gripscan {

/// What the images said of the step, else the row's own numbers; the worst first.
[[nodiscard]] std::vector<std::string> evidence_of(const JudgedStep& step,
                                                   const TurnLimits& limits);
/// "something of 220 mm² at (12, −40, 700) mm that the view before does not show".
[[nodiscard]] std::string description(const ForeignObject& object);

}  // namespace gripscan
