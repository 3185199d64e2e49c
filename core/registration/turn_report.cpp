#include "core/registration/turn_report.h"

#include <algorithm>

namespace gripscan {

bool all_trusted(const TurnReport& report) {
    return !report.steps.empty() &&
           std::all_of(report.steps.begin(), report.steps.end(), [](const TurnStep& step) {
               return step.verdict == Verdict::kAccept || step.verdict == Verdict::kAcceptNoted;
           });
}

}  // namespace gripscan
