// A session folder that is being recorded: locked for this program, images first, then the table,
// and the journal of how it came about.
#pragma once

#include "core/procedure/capture_store.h"
#include "core/session/folder_lock.h"
#include "core/session/journal_file.h"
#include "core/session/session.h"

namespace gripscan {

/// Nothing is recorded there yet: no folder, an empty one, or one whose creation was cut short. A
/// resume begins anew in it.
[[nodiscard]] bool is_fresh_session(const std::filesystem::path& folder);

/// store_images() and save_table() may be called from two threads at a time.
class SessionStore : public CaptureStore {
  public:
    /// Makes the folder with session.yaml, rig.yaml and, last, a journal that begins with
    /// `opening`, such as the plan: with the journal all of it is there. A folder that holds
    /// anything already is an error: recordings are never overwritten. After a failure it is
    /// empty.
    [[nodiscard]] static Result<SessionStore> create(const std::filesystem::path& folder,
                                                     const SessionSpec& spec, const StereoRig& rig,
                                                     std::string_view program_version,
                                                     std::span<const JournalRecord> opening = {});
    /// Locks an existing one to go on with it, and clears away what a crash left half. Errors: in
    /// use, not writable, no journal, or one of another version.
    [[nodiscard]] static Result<SessionStore> open(const std::filesystem::path& folder);

    [[nodiscard]] Journal& journal() { return journal_; }
    [[nodiscard]] Status store_images(int index, int attempt, const StereoFrame& frame) override;
    /// In session.yaml; the rest of it stays.
    [[nodiscard]] Status save_plan(const TurnPlan& plan) override;
    /// Columns that gripscan does not know are kept, with their cells.
    [[nodiscard]] Status save_table(std::span<const CaptureRecord> captures) override;
    [[nodiscard]] std::vector<RecordedCapture> recorded(
        std::span<const CaptureRecord> captures) const override;

  private:
    SessionStore(std::filesystem::path folder, FolderLock lock, JournalFile journal);

    std::filesystem::path folder_;
    FolderLock lock_;
    JournalFile journal_;
    CaptureTable found_;  ///< as it was when opened
};

}  // namespace gripscan
