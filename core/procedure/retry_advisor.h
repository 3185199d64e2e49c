// What to do about a step that was not accepted: the causes of UX.md's matrix, told apart by
// evidence, and a budget.
#pragma once

#include <span>
#include <string>

#include "core/procedure/advice.h"
#include "core/procedure/judged_step.h"
#include "core/procedure/turn_plan.h"

namespace gripscan {

struct AdvisorCase {
    JudgedStep step;                     ///< the one in question
    std::span<const JudgedStep> before;  ///< the rows of Table 1 before it, in order
    /// Earlier attempts from the same capture, oldest first: at the same angle, and at a larger one
    /// that was halved. They tell a ratio from a fixed error.
    std::span<const JudgedStep> attempts;
    double step_rad = 0.0;  ///< as it was commanded
    bool axis_locked = false;
    /// The warm-up's word where the surface does not show its turn; empty: it does.
    std::string turn_not_seen;
};

/// Pure. `plan` holds limits and budgets. Whatever comes, following the advice ends: an angle is
/// retaken, a step halved, the axis locked only so often, and going on turns the joint further.
[[nodiscard]] Advice advise(const AdvisorCase& c, const TurnPlan& plan);

}  // namespace gripscan
