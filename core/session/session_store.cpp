#include "core/session/session_store.h"

#include <algorithm>

#include "core/base/atomic_file.h"
#include "core/base/units.h"
#include "core/camera/image_file.h"
#include "core/stereo/rig_file.h"

namespace gripscan {
namespace {
namespace fs = std::filesystem;

/// What create() writes, in the order in which it is written after the lock.
constexpr std::array<std::string_view, 4> kCreated{"frames", "rig.yaml", "session.yaml", "journal"};

bool is_empty_folder(const fs::path& folder) {
    std::error_code code;
    return fs::is_directory(folder, code) && fs::is_empty(folder, code) && !code;
}

/// Nothing but parts of what create() writes, without a single entry of the journal. Only a folder
/// with a lock file is judged so: by hand, people make folders that look alike.
bool is_cut_short(const fs::path& folder) {
    std::error_code code;
    for (const auto& entry : fs::directory_iterator(folder, code)) {
        const std::string name = entry.path().filename().string();
        const bool ours = name == FolderLock::kFileName || is_temporary_name(name) ||
                          std::find(kCreated.begin(), kCreated.end(), name) != kCreated.end();
        if (!ours) return false;
    }
    if (fs::exists(folder / "frames", code) && !is_empty_folder(folder / "frames")) return false;
    const auto journal = read_journal(folder / "journal");
    return journal && journal->empty();
}

Status never_overwritten(const fs::path& folder) {
    return input_error(
        "cannot record into {}: the folder is not empty, and recordings are never overwritten; "
        "resume the one it holds, choose another folder or remove this one",
        folder.string());
}

Status make_folders(const fs::path& folder) {
    std::error_code code;
    if (fs::exists(folder, code) && !fs::is_directory(folder, code)) {
        return input_error("cannot record into {}: it is a file", folder.string());
    }
    fs::create_directories(folder, code);
    if (!code) return {};
    return input_error("cannot create {}: {}", folder.string(), code.message());
}

Result<JournalFile> fill(const fs::path& folder, const SessionSpec& spec, const StereoRig& rig,
                         std::string_view program_version, std::span<const JournalRecord> opening) {
    std::error_code code;
    fs::create_directories(folder / "frames", code);
    if (code) {
        return input_error("cannot create {}: {}", (folder / "frames").string(), code.message());
    }
    if (Status status = save_rig(folder / "rig.yaml", rig); !status) {
        return forward_error(status.error());
    }
    if (Status status = write_file_atomically(folder / "session.yaml", session_spec_text(spec));
        !status) {
        return forward_error(status.error());
    }
    return JournalFile::create(folder / "journal", program_version, opening);
}

void remove_created(const fs::path& folder) {
    std::error_code ignored;
    for (const auto name : kCreated) fs::remove_all(folder / name, ignored);
}

/// Empty where there is none, or none that can be read: it is written anew from the journal.
CaptureTable table_found(const fs::path& path) {
    const auto text = read_whole_file(path);
    if (!text) return {};
    return parse_capture_table(path, *text).value_or(CaptureTable{});
}

}  // namespace

bool is_fresh_session(const fs::path& folder) {
    std::error_code code;
    if (!fs::exists(folder, code)) return true;
    if (is_empty_folder(folder)) return true;
    return fs::exists(folder / FolderLock::kFileName, code) && is_cut_short(folder);
}

SessionStore::SessionStore(fs::path folder, FolderLock lock, JournalFile journal)
    : folder_(std::move(folder)), lock_(std::move(lock)), journal_(std::move(journal)) {
    found_ = table_found(folder_ / "captures.csv");
    if (found_.columns.empty()) found_.columns = all_capture_columns();
}

Result<SessionStore> SessionStore::create(const fs::path& folder, const SessionSpec& spec,
                                          const StereoRig& rig, std::string_view program_version,
                                          std::span<const JournalRecord> opening) {
    if (Status status = make_folders(folder); !status) return forward_error(status.error());
    const bool was_fresh = is_fresh_session(folder);
    std::error_code code;
    const bool was_locked = fs::exists(folder / FolderLock::kFileName, code);
    if (!was_fresh && !was_locked) return forward_error(never_overwritten(folder).error());
    auto lock = FolderLock::take(folder);
    if (!lock) return forward_error(lock.error());
    remove_dead_leftovers(folder);
    // Again, now that nobody else can change it.
    if (!was_fresh || !is_cut_short(folder)) {
        return forward_error(never_overwritten(folder).error());
    }
    auto journal = fill(folder, spec, rig, program_version, opening);
    if (!journal) {
        remove_created(folder);
        return forward_error(journal.error());
    }
    return SessionStore(folder, std::move(*lock), std::move(*journal));
}

Result<SessionStore> SessionStore::open(const fs::path& folder) {
    auto lock = FolderLock::take(folder);
    if (!lock) return forward_error(lock.error());
    auto journal = JournalFile::open(folder / "journal");
    if (!journal) return forward_error(journal.error());
    std::error_code code;
    fs::create_directories(folder / "frames", code);
    if (code) {
        return input_error("cannot create {}: {}", (folder / "frames").string(), code.message());
    }
    remove_dead_leftovers(folder);
    remove_dead_leftovers(folder / "frames");
    return SessionStore(folder, std::move(*lock), std::move(*journal));
}

Status SessionStore::store_images(int index, int attempt, const StereoFrame& frame) {
    CaptureRecord capture;
    capture.index = index;
    capture.attempt = attempt;
    const CaptureRow row = row_of(capture);
    if (Status status = save_png(folder_ / row.left, frame.left); !status) return status;
    return save_png(folder_ / row.right, frame.right);
}

Status SessionStore::save_plan(const TurnPlan& plan) {
    auto spec = read_session_spec(folder_ / "session.yaml");
    if (!spec) return forward_error(spec.error());
    spec->step_deg = deg_from_rad(plan.step_rad);
    spec->limits = limits_deg(plan.limits);
    return write_file_atomically(folder_ / "session.yaml", session_spec_text(*spec));
}

Status SessionStore::save_table(std::span<const CaptureRecord> captures) {
    CaptureTable table;
    table.columns = found_.columns;
    for (const auto& capture : captures) {
        CaptureRow row = row_of(capture);
        const auto found =
            std::find_if(found_.rows.begin(), found_.rows.end(),
                         [&](const CaptureRow& other) { return other.index == row.index; });
        if (found != found_.rows.end()) row.other = found->other;
        table.rows.push_back(std::move(row));
    }
    return write_file_atomically(folder_ / "captures.csv", capture_table_text(table));
}

std::vector<RecordedCapture> SessionStore::recorded(std::span<const CaptureRecord> captures) const {
    Session session;
    session.folder = folder_;
    for (const auto& capture : captures) session.table.rows.push_back(row_of(capture));
    return recording_of(session).captures;
}

}  // namespace gripscan
