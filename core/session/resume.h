// What a session folder remembers of a procedure that has not come to its end.
#pragma once

#include "core/session/session_store.h"

namespace gripscan {

struct SessionMemory {
    std::filesystem::path folder;
    SessionSpec spec;
    StereoRig rig;
    JournalHeader header;
    std::vector<JournalEntry> entries;  ///< all that happened, in order
};

/// Reads only. captures.csv is not asked: what it says is in the journal, from which it is written
/// anew. Errors, each with what can be done about it: no session, no journal, a damaged line, a
/// journal of another version.
[[nodiscard]] Result<SessionMemory> open_memory(const std::filesystem::path& folder);

struct ResumedSession {
    SessionStore store;
    SessionMemory memory;
};

/// Locks the session, so that what is read stays true, and goes on with it. Fold
/// `memory.entries` into the state, then call `store.save_table()` with its captures.
[[nodiscard]] Result<ResumedSession> resume_session(const std::filesystem::path& folder);

}  // namespace gripscan
