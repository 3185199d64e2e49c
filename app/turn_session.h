// A session folder while a turn is recorded into it: made, or opened to go on, with the state that
// its journal leads to.
#pragma once

#include <filesystem>
#include <optional>

#include "app/cell_options.h"
#include "app/open_cell.h"
#include "core/procedure/procedure_state.h"
#include "core/session/resume.h"

namespace gripscan::app {

struct TurnSession {
    SessionStore store;
    SessionSpec spec;
    ProcedureState state;
};

/// Makes the folder and begins its journal: which cell, and the plan. With a gripper's template (as
/// the session shall name it) it is the turn of an object.
[[nodiscard]] Result<TurnSession> begin_session(
    const std::filesystem::path& folder, const CellOptions& options, const Cell& cell,
    const std::optional<std::string>& gripper_template = std::nullopt);

/// Writes what is known of where the camera stands into the session, as alignment.yaml.
[[nodiscard]] Status keep_alignment(const std::filesystem::path& folder, const Cell& cell);

/// What a resumed session says about its cell, before that is opened.
struct RememberedSession {
    SessionStore store;
    SessionSpec spec;
    CellOptions options;
    ProcedureState state;  ///< after the last entry
};
/// What the journal of a session leads to; reads only. Errors: no journal, a damaged one, one of
/// another version or of no run.
struct RecalledSession {
    CellOptions options;
    ProcedureState state;
};
[[nodiscard]] Result<RecalledSession> recall_session(const SessionMemory& memory);

[[nodiscard]] Result<RememberedSession> remember_session(const std::filesystem::path& folder);

}  // namespace gripscan::app
