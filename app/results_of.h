// The results of a session, whether they lie there already or have to be computed.
#pragma once

#include "app/turn_work.h"

namespace gripscan::app {

struct ResultsOf {
    Session session;
    TurnReport report;  ///< with the template's points
};

/// SESSION/results where they are; else computed as replay does, without writing anything.
[[nodiscard]] Result<ResultsOf> results_of(const std::filesystem::path& session,
                                           const Context& context);

}  // namespace gripscan::app
