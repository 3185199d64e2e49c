// Rows of Table 1 as the advisor meets them, and the advice for them.
#pragma once

#include <vector>

#include "core/base/units.h"
#include "core/procedure/retry_advisor.h"

namespace gripscan::test {

using enum AdvisedAction;

inline constexpr double kStep_deg = 10.0;
/// What the registration predicts for the simulated cell.
inline constexpr double kSigma_deg = 0.04;

inline JudgedStep row(Verdict verdict, Cause cause, double error_deg = 0.0,
                      double step_deg = kStep_deg) {
    JudgedStep step;
    step.row.from = 4;
    step.row.to = 5;
    step.row.commanded_rad = rad_from_deg(step_deg);
    step.row.robot_rad = rad_from_deg(step_deg);
    step.row.icp_rad = rad_from_deg(step_deg + error_deg);
    step.row.error_rad = rad_from_deg(error_deg);
    step.row.sigma_rad = rad_from_deg(kSigma_deg);
    step.row.tilt_rad = rad_from_deg(0.2);
    step.row.slip_m = 0.05e-3;
    step.row.overlap = 0.8;
    step.row.observability = 0.4;
    step.row.verdict = verdict;
    step.row.cause = cause;
    return step;
}
inline JudgedStep rejected(Cause cause, double error_deg = 0.0, double step_deg = kStep_deg) {
    return row(Verdict::kReject, cause, error_deg, step_deg);
}
inline JudgedStep checked(Cause cause, double error_deg = 0.0, double step_deg = kStep_deg) {
    return row(Verdict::kCheck, cause, error_deg, step_deg);
}
inline JudgedStep accepted(double error_deg = 0.02) {
    return row(Verdict::kAccept, Cause::kNone, error_deg);
}
inline JudgedStep wrong(double error_deg, double step_deg = kStep_deg) {
    return rejected(Cause::kMislabelled, error_deg, step_deg);
}

using Rows = std::vector<JudgedStep>;

inline Advice advice_for(const JudgedStep& step, const Rows& before, const Rows& attempts,
                         double step_deg = kStep_deg, bool locked = false,
                         const TurnPlan& plan = {}, std::string turn_not_seen = {}) {
    return advise({step, before, attempts, rad_from_deg(step_deg), locked, std::move(turn_not_seen)},
                  plan);
}

}  // namespace gripscan::test
