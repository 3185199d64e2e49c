#include "app/exam_views.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <numbers>
#include <thread>

#include "app/console.h"
#include "app/open_cell.h"
#include "core/base/seeded_random.h"
#include "core/base/units.h"
#include "core/procedure/turn_workspace.h"
#include "core/robot/kinematics.h"

namespace gripscan::app {
namespace {

/// Held-out angles keep this away from those of the template.
constexpr double kApart_rad = 2.0 * kRadPerDeg;

Result<TurnWorkspace> workspace_for(const Session& session, const StereoRig& rig,
                                    const std::optional<Box>& region) {
    return TurnWorkspace::create(rig, region, compute_settings_of(session));
}

std::vector<double> held_out_angles(const Session& session, int count, std::uint64_t seed) {
    std::vector<double> taken;
    for (const CaptureRow& row : session.table.rows) {
        if (const auto angle = joint6_rad(row)) taken.push_back(*angle);
    }
    // Within half a turn of the first capture, as the turn itself was.
    const double middle = taken.empty() ? 0.0 : taken.front();
    const double low = std::max(joint_ranges()[5].min_rad + 0.05, middle - std::numbers::pi);
    const double high = std::min(joint_ranges()[5].max_rad - 0.05, middle + std::numbers::pi);
    SeededRandom random(seed);
    std::vector<double> angles;
    for (int attempt = 0; attempt < 1000 * count && static_cast<int>(angles.size()) < count;
         ++attempt) {
        const double angle = random.uniform(low, high);
        const bool apart = std::all_of(taken.begin(), taken.end(), [&](double t) {
            return std::abs(std::remainder(t - angle, 2.0 * std::numbers::pi)) > kApart_rad;
        });
        if (apart) angles.push_back(angle);
    }
    std::sort(angles.begin(), angles.end());
    return angles;
}

/// Turns to the angle; a controller that has passed our id tells where to go on.
Result<RobotReading> turn_to(RobotLink& robot, Joint6Command& command, const Context& context) {
    auto reading = robot.turn_joint6(command, context.stop);
    if (!reading && reading.error().fault == RobotFault::kStaleId) {
        command.id = reading.error().last_id + 1;
        reading = robot.turn_joint6(command, context.stop);
    }
    ++command.id;
    if (!reading && context.stop.stop_requested()) return cancelled_error();
    if (!reading) return forward_error(as_error(reading.error()));
    return *reading;
}

}  // namespace

std::optional<double> joint6_rad(const CaptureRow& row) {
    const auto& before = row.joints_deg[5];
    if (!before) return std::nullopt;
    return rad_from_deg(0.5 * (*before + row.j6_after_deg.value_or(*before)));
}

Result<std::vector<ExamView>> recorded_exam(const Session& session,
                                            const std::vector<int>& captures,
                                            const Progress& progress, const ForEach& for_each) {
    const TurnRecording recording = recording_of(session);
    const auto workspace =
        TurnWorkspace::create(recording.rig, recording.region, compute_settings_of(session));
    if (!workspace) return forward_error(workspace.error());
    std::vector<ExamView> views;
    for (std::size_t i = 0; i < recording.captures.size(); ++i) {
        const CaptureRow& row = session.table.rows[i];
        const bool named = std::find(captures.begin(), captures.end(), row.index) != captures.end();
        if (captures.empty() ? row.status != CaptureStatus::kExcluded : !named) continue;
        const auto angle = joint6_rad(row);
        if (!angle) return input_error("capture {} has no reading of joint 6", row.index);
        auto prepared = workspace->prepare(recording.captures[i], progress, for_each);
        if (!prepared) return forward_error(prepared.error());
        views.push_back({row.index, *angle, std::move(prepared->view.cloud)});
    }
    if (views.empty()) {
        return input_error(
            "{} holds no capture to be examined by: name some with --captures, or exclude some "
            "before the template is computed",
            session.folder.string());
    }
    return views;
}

Result<std::vector<ExamView>> driven_exam(const Session& session, const ExamDrive& drive,
                                          const Context& context, const Progress& progress,
                                          const ForEach& for_each) {
    if (!drive.cell.simulated() && !drive.cell.live) {
        return input_error("--drive turns joint 6: of a real controller it wants --live");
    }
    auto cell = open_cell(drive.cell, context.stop, remarks(context));
    if (!cell) return forward_error(cell.error());
    if (!cell->robot) return input_error("the exam turns joint 6 itself: a robot is needed");
    if (const auto identity = cell->robot->connect(); !identity) {
        return forward_error(as_error(identity.error()));
    }
    const auto workspace = workspace_for(session, cell->rig, cell->region);
    if (!workspace) return forward_error(workspace.error());
    const auto angles = held_out_angles(session, drive.angles, drive.seed);
    std::vector<ExamView> views;
    Joint6Command command{.id = 1};
    command.speed_percent = cell->speed_percent;
    for (const double angle : angles) {
        progress.tell("held-out angles", views.size(), angles.size());
        command.angle_rad = angle;
        const auto reading = turn_to(*cell->robot, command, context);
        if (!reading) return forward_error(reading.error());
        if (cell->simulated == nullptr) {
            std::this_thread::sleep_for(std::chrono::duration<double>(cell->settle_s));
        }
        RecordedCapture capture;
        capture.index = static_cast<int>(views.size());
        capture.load_images = [&] { return cell->camera->grab({.capture = capture.index}); };
        auto prepared = workspace->prepare(capture, progress, for_each);
        if (!prepared) return forward_error(prepared.error());
        views.push_back({capture.index, reading->joints_rad[5], std::move(prepared->view.cloud)});
    }
    return views;
}

}  // namespace gripscan::app
