// Causes that only several steps together show.
#pragma once

#include <span>

#include "core/registration/step_evidence.h"
#include "core/registration/turn_report.h"

namespace gripscan {

/// Patterns over all steps that name a cause a single step cannot show: angles with the sign turned
/// round, one ratio in all of them (of the robot, or of distorted depth where a closed turn tells
/// them apart), lost motion of the joint, a part that slips once or shakes.
/// `scale` is the joint solution's, where it found one; `closed` says that it saw a whole turn.
/// Verdicts change only for sign and ratio.
void find_common_cause(std::span<TurnStep> steps, const TurnLimits& limits,
                       std::optional<double> scale, bool closed = false);

}  // namespace gripscan
