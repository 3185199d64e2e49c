// The evidence of a step in words, for whoever wants to see what a verdict rests on.
#pragma once

#include <string>
#include <vector>

#include "core/registration/step_evidence.h"
#include "core/registration/turn_report.h"

namespace gripscan {

/// One thing that was looked at.
struct EvidenceLine {
    std::string what;   ///< "overlap", "camera", …
    std::string value;  ///< with unit; "not known" where it could not be measured
    std::string limit;
    bool exceeded = false;
};

/// In the order of the causes of the contract; the same for the same evidence.
[[nodiscard]] std::vector<EvidenceLine> evidence_lines(const TurnStep& step,
                                                       const StepEvidence& evidence,
                                                       const TurnLimits& limits);

}  // namespace gripscan
