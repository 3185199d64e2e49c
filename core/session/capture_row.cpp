#include <cmath>

#include "core/base/units.h"
#include "core/session/capture_table.h"
#include "core/session/csv_text.h"

namespace gripscan {
namespace {

/// A millionth of a unit is far below what any encoder tells, and 10° is written as 10.
double tidy(double value) {
    return std::round(value * 1e9) / 1e9;
}

double tidy_deg(double rad) {
    return tidy(deg_from_rad(rad));
}

void write_reading(CaptureRow& row, const RobotReading& reading) {
    for (std::size_t i = 0; i < row.joints_deg.size(); ++i) {
        row.joints_deg[i] = tidy_deg(reading.joints_rad[i]);
    }
    const Pose& tool = reading.T_world_tool;
    const EulerAngles wpr = euler_from_rotation(tool.linear());
    row.tool = {tidy(tool.translation().x() * kMmPerM),
                tidy(tool.translation().y() * kMmPerM),
                tidy(tool.translation().z() * kMmPerM),
                tidy_deg(wpr.roll_rad),
                tidy_deg(wpr.pitch_rad),
                tidy_deg(wpr.yaw_rad)};
}

}  // namespace

CaptureRow row_of(const CaptureRecord& capture) {
    CaptureRow row;
    row.index = capture.index;
    row.commanded_deg = tidy_deg(capture.commanded_rad);
    if (capture.before) write_reading(row, *capture.before);
    if (capture.joint6_after_rad) row.j6_after_deg = tidy_deg(*capture.joint6_after_rad);
    // A retake of an earlier view keeps its index: its images must not replace the first ones.
    const std::string attempt = capture.attempt == 1 ? "" : fmt::format("_{}", capture.attempt);
    row.left = fmt::format("frames/{:03}{}_left.png", capture.index, attempt);
    row.right = fmt::format("frames/{:03}{}_right.png", capture.index, attempt);
    row.t_s = tidy(capture.t_s);
    row.attempt = capture.attempt;
    row.status = capture.status;
    row.mode = capture.mode;
    row.note = trimmed(capture.note);  // as it will be read
    return row;
}

}  // namespace gripscan
