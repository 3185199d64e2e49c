#include "core/session/session_recorder.h"

#include <cmath>

#include "core/base/atomic_file.h"
#include "core/base/units.h"
#include "core/camera/image_file.h"
#include "core/stereo/rig_file.h"

namespace gripscan {
namespace {
namespace fs = std::filesystem;

/// A millionth of a unit is far below what any encoder tells, and 10° is written as 10.
double tidy(double value) {
    return std::round(value * 1e9) / 1e9;
}

double tidy_deg(double rad) {
    return tidy(deg_from_rad(rad));
}

CaptureRow row_of(const TakenCapture& capture) {
    CaptureRow row;
    row.index = capture.index;
    row.commanded_deg = tidy_deg(capture.commanded_rad);
    for (std::size_t i = 0; i < row.joints_deg.size(); ++i) {
        row.joints_deg[i] = tidy_deg(capture.before.joints_rad[i]);
    }
    row.j6_after_deg = tidy_deg(capture.after.joints_rad[5]);
    const Pose& tool = capture.before.T_world_tool;
    const EulerAngles wpr = euler_from_rotation(tool.linear());
    for (int i = 0; i < 3; ++i) {
        row.tool[static_cast<std::size_t>(i)] = tidy(tool.translation()[i] * kMmPerM);
    }
    row.tool[3] = tidy_deg(wpr.roll_rad);
    row.tool[4] = tidy_deg(wpr.pitch_rad);
    row.tool[5] = tidy_deg(wpr.yaw_rad);
    row.left = fmt::format("frames/{:03}_left.png", capture.index);
    row.right = fmt::format("frames/{:03}_right.png", capture.index);
    row.t_s = tidy(capture.frame.t_s);
    row.attempt = 1;
    return row;
}

}  // namespace

SessionRecorder::SessionRecorder(fs::path folder) : folder_(std::move(folder)) {
    table_.columns = all_capture_columns();
}

Result<SessionRecorder> SessionRecorder::create(const fs::path& folder, const SessionSpec& spec,
                                                const StereoRig& rig) {
    std::error_code code;
    if (fs::exists(folder, code) && !fs::is_directory(folder, code)) {
        return input_error("cannot record into {}: it is a file", folder.string());
    }
    if (fs::exists(folder, code) && !fs::is_empty(folder, code)) {
        return input_error(
            "cannot record into {}: the folder is not empty, and recordings are "
            "never overwritten; choose another folder or remove this one",
            folder.string());
    }
    fs::create_directories(folder / "frames", code);
    if (code) {
        return input_error("cannot create {}: {}", (folder / "frames").string(), code.message());
    }
    if (Status status = write_file_atomically(folder / "session.yaml", session_spec_text(spec));
        !status) {
        return forward_error(status.error());
    }
    if (Status status = save_rig(folder / "rig.yaml", rig); !status) {
        return forward_error(status.error());
    }
    return SessionRecorder(folder);
}

Status SessionRecorder::store(const TakenCapture& capture) {
    CaptureRow row = row_of(capture);
    if (Status status = save_png(folder_ / row.left, capture.frame.left); !status) return status;
    if (Status status = save_png(folder_ / row.right, capture.frame.right); !status) return status;
    table_.rows.push_back(std::move(row));
    return write_file_atomically(folder_ / "captures.csv", capture_table_text(table_));
}

}  // namespace gripscan
