#include "core/session/resume.h"

#include "core/base/atomic_file.h"
#include "core/stereo/rig_file.h"

namespace gripscan {
namespace {
namespace fs = std::filesystem;

tl::unexpected<Error> cannot_resume(const fs::path& folder, const Error& why) {
    return input_error("cannot resume {}: {}; what was recorded can be computed: gripscan replay",
                       folder.string(), why.message);
}

Status check_folder(const fs::path& folder) {
    std::error_code code;
    if (fs::is_directory(folder, code)) return {};
    return input_error(
        "no session at {}: {}", folder.string(),
        fs::exists(folder, code) ? "it is not a folder" : "the folder does not exist");
}

}  // namespace

Result<SessionMemory> open_memory(const fs::path& folder) {
    if (Status status = check_folder(folder); !status) return forward_error(status.error());
    SessionMemory memory;
    memory.folder = folder;
    auto journal = read_journal(folder / "journal");
    if (!journal) return cannot_resume(folder, journal.error());
    if (Status status = check_journal_version(folder / "journal", *journal); !status) {
        return cannot_resume(folder, status.error());
    }
    memory.header = *journal->header;
    memory.entries = std::move(journal->entries);
    auto spec = read_session_spec(folder / "session.yaml");
    if (!spec) return forward_error(spec.error());
    memory.spec = std::move(*spec);
    auto rig = load_rig(folder / "rig.yaml");
    if (!rig) return forward_error(rig.error());
    memory.rig = std::move(*rig);
    return memory;
}

Result<ResumedSession> resume_session(const fs::path& folder) {
    // Before the lock: a folder that cannot be resumed is not written to.
    if (auto readable = open_memory(folder); !readable) return forward_error(readable.error());
    auto store = SessionStore::open(folder);
    if (!store) return forward_error(store.error());
    auto memory = open_memory(folder);
    if (!memory) return forward_error(memory.error());
    return ResumedSession{std::move(*store), std::move(*memory)};
}

}  // namespace gripscan
