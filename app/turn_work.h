// A recorded turn computed and delivered: the same code for replay, run, report and export.
#pragma once

#include <filesystem>

#include "app/context.h"
#include "app/turn_options.h"
#include "core/session/session.h"

namespace gripscan::app {

struct TurnWork {
    Session session;
    ComputeTurnSettings settings;
    ComputedTurn computed;
};

/// Opens the session, checks every file it names, computes.
[[nodiscard]] Result<TurnWork> compute_session(const std::filesystem::path& folder,
                                               const TurnOptions& options, const Context& context);

/// Writes the results as a whole, prints the JSON or the table, tells by the status whether every
/// step can be trusted.
[[nodiscard]] Result<ExitStatus> deliver(const TurnWork& work, const std::filesystem::path& out,
                                         const Context& context);

/// Only the printing: the results lie in `out` already.
[[nodiscard]] ExitStatus tell_results(const TurnWork& work, const std::filesystem::path& out,
                                      const Context& context);

/// 0 if every step is accepted, else 1.
[[nodiscard]] ExitStatus trust(const TurnReport& report);

[[nodiscard]] std::filesystem::path absolute_path(const std::filesystem::path& path);

}  // namespace gripscan::app
