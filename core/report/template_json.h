// template.json: where a template comes from, so that whoever loads it can tell whether it is still
// what the recording says.
#pragma once

#include <string>

#include "core/procedure/compute_turn.h"
#include "core/session/session.h"

namespace gripscan {

struct Provenance {
    const Session& session;
    const ComputeTurnSettings& settings;
    std::string version;  ///< of the software
};

/// Unit, frame, points, check sums of every source file, settings, closure, summary of Table 1.
[[nodiscard]] Result<std::string> template_json(const TurnReport& report, const Provenance& from);

}  // namespace gripscan
