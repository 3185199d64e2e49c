#include "core/base/atomic_file.h"
#include "core/session/session.h"
#include "core/stereo/rig_file.h"

namespace gripscan {
namespace {
namespace fs = std::filesystem;

/// What a row must name so that it can be used.
Status check_row(const fs::path& csv, const CaptureRow& row, bool has_rig) {
    const auto where = [&] {
        return fmt::format("{}:{}: capture {}", csv.string(), row.line, row.index);
    };
    if (row.left.empty() != row.right.empty()) {
        return input_error("{} names only one image; a pair needs 'left' and 'right'", where());
    }
    if (row.status != CaptureStatus::kUsed) return {};
    if (row.left.empty() && row.cloud.empty()) {
        return input_error("{} names neither images nor a cloud", where());
    }
    if (!row.left.empty() && !has_rig) {
        return input_error("{} names images, but the session has no rig.yaml", where());
    }
    return {};
}

Result<CaptureTable> read_table(const fs::path& path, bool has_rig) {
    const auto text = read_whole_file(path);
    if (!text) return forward_error(text.error());
    auto table = parse_capture_table(path, *text);
    if (!table) return table;
    std::size_t used = 0;
    for (const auto& row : table->rows) {
        if (Status status = check_row(path, row, has_rig); !status) {
            return forward_error(status.error());
        }
        if (row.status == CaptureStatus::kUsed) ++used;
    }
    if (used < 2) {
        return input_error("{}: a turn needs at least two used captures, there {} {}",
                           path.string(), used == 1 ? "is" : "are", used);
    }
    return table;
}

}  // namespace

Result<Session> open_session(const fs::path& folder) {
    std::error_code code;
    if (!fs::is_directory(folder, code)) {
        return input_error(
            "no session at {}: {}", folder.string(),
            fs::exists(folder, code) ? "it is not a folder" : "the folder does not exist");
    }
    Session session;
    session.folder = folder;
    auto spec = read_session_spec(folder / "session.yaml");
    if (!spec) return forward_error(spec.error());
    session.spec = std::move(*spec);
    const bool has_rig = fs::exists(folder / "rig.yaml", code);
    if (has_rig) {
        auto rig = load_rig(folder / "rig.yaml");
        if (!rig) return forward_error(rig.error());
        session.rig = std::move(*rig);
    }
    auto table = read_table(folder / "captures.csv", has_rig);
    if (!table) return forward_error(table.error());
    session.table = std::move(*table);
    return session;
}

}  // namespace gripscan
