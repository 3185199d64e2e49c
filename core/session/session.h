// A session folder as it lies on the disk: session.yaml, rig.yaml, captures.csv and the files they
// name. Opening reads the descriptions; checking opens every file that is named.
#pragma once

#include <filesystem>
#include <optional>

#include "core/base/for_each.h"
#include "core/geometry/stereo_rig.h"
#include "core/procedure/compute_turn.h"
#include "core/session/capture_table.h"
#include "core/session/session_spec.h"

namespace gripscan {

struct Session {
    std::filesystem::path folder;
    SessionSpec spec;
    std::optional<StereoRig> rig;
    CaptureTable table;

    [[nodiscard]] std::filesystem::path file(const std::string& relative) const {
        return folder / relative;
    }
    /// Images are the raw data: where a row has both, they are used and the cloud is not.
    [[nodiscard]] static bool uses_images(const CaptureRow& row) {
        return !row.left.empty() && !row.right.empty();
    }
};

/// Reads and validates the descriptions. The message names file, line and reason.
[[nodiscard]] Result<Session> open_session(const std::filesystem::path& folder);

/// Opens every file the table names, those of superseded and excluded rows too: absent, unreadable,
/// cut short, of another size than the rig's. The first bad one in order of the table is named.
[[nodiscard]] Status check_session_files(const Session& session, const Progress& progress,
                                         const ForEach& for_each);

/// The session as the pipeline takes it. It refers to files by path; `session` may go.
[[nodiscard]] TurnRecording recording_of(const Session& session);

/// Settings with the session's step, axis hint and limits, everything else as it is by default.
[[nodiscard]] ComputeTurnSettings compute_settings_of(const Session& session);

}  // namespace gripscan
