#include <algorithm>
#include <cmath>

#include "core/base/units.h"
#include "core/camera/image_file.h"
#include "core/cloud/cloud_file.h"
#include "core/session/session.h"

namespace gripscan {
namespace {
namespace fs = std::filesystem;

std::optional<double> rad_of(const std::optional<double>& deg) {
    if (!deg) return std::nullopt;
    return rad_from_deg(*deg);
}

std::optional<std::array<double, 5>> other_joints(const CaptureRow& row) {
    std::array<double, 5> joints{};
    for (std::size_t i = 0; i < joints.size(); ++i) {
        if (!row.joints_deg[i]) return std::nullopt;
        joints[i] = rad_from_deg(*row.joints_deg[i]);
    }
    return joints;
}

Result<StereoFrame> load_pair(const fs::path& left, const fs::path& right, double t_s) {
    auto first = load_grey_image(left);
    if (!first) return forward_error(first.error());
    auto second = load_grey_image(right);
    if (!second) return forward_error(second.error());
    return StereoFrame{std::move(*first), std::move(*second), t_s};
}

/// Attempts as written, else one more than the retaken rows just before this one.
int attempts_of(const std::vector<CaptureRow>& rows, std::size_t i) {
    if (rows[i].attempt) return *rows[i].attempt;
    int attempts = 1;
    while (i > 0 && rows[i - 1].status == CaptureStatus::kSuperseded) {
        ++attempts;
        --i;
    }
    return attempts;
}

RecordedCapture capture_of(const Session& session, std::size_t i) {
    const CaptureRow& row = session.table.rows[i];
    RecordedCapture capture;
    capture.index = row.index;
    capture.used = row.status == CaptureStatus::kUsed;
    capture.attempts = attempts_of(session.table.rows, i);
    capture.mode = row.mode;
    capture.note = row.note;
    capture.commanded_rad = rad_of(row.commanded_deg);
    capture.joint6_rad = rad_of(row.joints_deg[5]);
    capture.joint6_after_rad = rad_of(row.j6_after_deg);
    capture.other_joints_rad = other_joints(row);
    if (Session::uses_images(row)) {
        capture.load_images = [left = session.file(row.left), right = session.file(row.right),
                               t_s = row.t_s.value_or(0.0)] { return load_pair(left, right, t_s); };
    } else if (!row.cloud.empty()) {
        capture.load_cloud = [path = session.file(row.cloud)] { return load_cloud(path); };
    }
    return capture;
}

/// Median of the turns between consecutive used rows, deg.
std::optional<double> usual_step_deg(const CaptureTable& table,
                                     std::optional<double> (*angle)(const CaptureRow&)) {
    std::vector<double> steps;
    std::optional<double> last;
    for (const auto& row : table.rows) {
        if (row.status != CaptureStatus::kUsed || !angle(row)) continue;
        if (last) steps.push_back(std::abs(*angle(row) - *last));
        last = angle(row);
    }
    if (steps.empty()) return std::nullopt;
    const auto middle = steps.begin() + static_cast<std::ptrdiff_t>(steps.size() / 2);
    std::nth_element(steps.begin(), middle, steps.end());
    return *middle;
}

}  // namespace

TurnRecording recording_of(const Session& session) {
    TurnRecording recording;
    recording.rig = session.rig;
    recording.region = session.spec.region;
    for (std::size_t i = 0; i < session.table.rows.size(); ++i) {
        recording.captures.push_back(capture_of(session, i));
    }
    return recording;
}

ComputeTurnSettings compute_settings_of(const Session& session) {
    const SessionSpec& spec = session.spec;
    ComputeTurnSettings settings;
    std::optional<double> step_deg = spec.step_deg;
    if (!step_deg) {
        step_deg =
            usual_step_deg(session.table, [](const CaptureRow& r) { return r.commanded_deg; });
    }
    if (!step_deg) {
        step_deg =
            usual_step_deg(session.table, [](const CaptureRow& r) { return r.joints_deg[5]; });
    }
    if (step_deg && *step_deg != 0.0) settings.turn.step_rad = rad_from_deg(std::abs(*step_deg));
    if (spec.axis_hint) settings.turn.axis_hint = spec.axis_hint->normalized();
    settings.turn.limits = turn_limits(spec.limits);
    settings.turn.align.limits = settings.turn.limits;
    return settings;
}

}  // namespace gripscan
