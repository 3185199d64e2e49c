#include "core/registration/turn_report.h"

#include <algorithm>

namespace gripscan {

bool trusted(const TurnStep& step) {
    return step.verdict == Verdict::kAccept || step.verdict == Verdict::kAcceptNoted;
}

std::size_t trusted_steps(const TurnReport& report) {
    return static_cast<std::size_t>(
        std::count_if(report.steps.begin(), report.steps.end(), trusted));
}

bool all_trusted(const TurnReport& report) {
    return !report.steps.empty() && trusted_steps(report) == report.steps.size();
}

}  // namespace gripscan
