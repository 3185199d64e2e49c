// The check of a step against the robot: verdict, cause and the sentence that says both.
#pragma once

#include <span>
#include <vector>

#include "core/registration/turn_report.h"

namespace gripscan {

/// What is known about a step beside its row.
struct StepEvidence {
    bool found = false;
    Cause cause_not_found = Cause::kNotConverged;
    std::string why_not_found;  ///< empty: nothing more is known
    bool starts_agree = true;
    double least_observability = 0.0;
    double joint6_moved_rad = 0.0;        ///< between the readings before and after an exposure
    double other_joints_moved_rad = 0.0;  ///< largest change of J1 … J5
    bool paper_icp = false;               ///< no uncertainty, no observability
};

/// Sets verdict, cause and sentence of one step from its numbers alone (contract: accept within
/// all limits, check below twice a limit or when not independent, reject beyond).
void judge_step(TurnStep& step, const StepEvidence& evidence, const TurnLimits& limits);

/// Patterns over all steps that name a cause a single step cannot show: angles with the sign
/// turned round, one ratio in all of them. `scale` is the joint solution's, where it found one.
void find_common_cause(std::span<TurnStep> steps, const TurnLimits& limits,
                       std::optional<double> scale);

}  // namespace gripscan
