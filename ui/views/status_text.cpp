#include "ui/views/status_text.h"

#include <fmt/format.h>

#include <cmath>

#include "core/base/units.h"
#include "core/registration/turn_check.h"
#include "ui/theme/shown_number.h"
#include "ui/views/activity_text.h"
#include "ui/views/step_text.h"

namespace gripscan::ui {
namespace {

struct RobotWords {
    std::string text;
    State state;
};

RobotWords robot_of(const ProcedureState& state) {
    if (const auto* offline = std::get_if<phase::Offline>(&state.phase)) {
        return {"Offline", offline->why.empty() ? State::kWaiting : State::kReject};
    }
    if (std::holds_alternative<phase::Connecting>(state.phase)) {
        return {"Connecting", State::kRunning};
    }
    if (std::holds_alternative<phase::Interrupted>(state.phase)) {
        return {"Interrupted", State::kCheck};
    }
    if (std::holds_alternative<phase::Halting>(state.phase)) return {"Stopping", State::kRunning};
    if (const Activity* activity = activity_of(state)) {
        return {std::string(activity_word(*activity)), State::kRunning};
    }
    if (std::holds_alternative<phase::Deciding>(state.phase)) return {"Waits", State::kCheck};
    return {"Ready", State::kAccept};
}

/// Joints 1 … 5 against the first capture, or against nothing.
void tell_others(const ProcedureState& state, StatusText& status) {
    const auto used = state.data.used();
    if (!state.reading || used.empty() || !state.data.captures[used.front()].before) return;
    const JointAngles& first = state.data.captures[used.front()].before->joints_rad;
    std::size_t most = 0;
    double moved_rad = 0.0;
    for (std::size_t i = 0; i < 5; ++i) {
        const double by_rad = std::abs(state.reading->joints_rad[i] - first[i]);
        if (by_rad > moved_rad) {
            moved_rad = by_rad;
            most = i + 1;
        }
    }
    status.others_moved = moved_rad > kJointStill_rad;
    status.other_joints =
        status.others_moved
            ? fmt::format("J{} moved {}°", most, shown_number(deg_from_rad(moved_rad), 2))
            : "J1–J5 still";
}

}  // namespace

StatusText status_of(const Snapshot& s) {
    StatusText status;
    if (s.procedure == nullptr) return status;
    const ProcedureState& state = *s.procedure;
    const RobotWords robot = robot_of(state);
    status.robot = robot.text;
    status.robot_state = robot.state;
    if (const auto joint6_rad = standing_joint6_rad(state)) {
        status.joint6 = shown_number(deg_from_rad(*joint6_rad), 3) + "°";
    }
    tell_others(state, status);
    for (const JudgedStep& step : table_of(state)) {
        status.checks += step.row.verdict == Verdict::kCheck ? 1 : 0;
        status.rejected += step.row.verdict == Verdict::kReject ? 1 : 0;
    }
    return status;
}

std::string cursor_text(const CursorReading& reading) {
    const Eigen::Vector3d mm = kMmPerM * reading.point_m;
    std::string text = fmt::format("x {}  y {}  z {} mm", shown_number(mm.x(), 2),
                                   shown_number(mm.y(), 2), shown_number(mm.z(), 2));
    if (reading.residual_m) {
        text += fmt::format("   residual {} mm", shown_number(kMmPerM * *reading.residual_m, 2));
    }
    if (reading.step) text += fmt::format("   step {}", *reading.step);
    return text;
}

std::string duration_text(double seconds) {
    if (!std::isfinite(seconds) || seconds < 0.0) return "–";
    const auto whole = static_cast<long long>(seconds);
    if (whole < 60) return fmt::format("{} s", whole);
    if (whole < 3600) return fmt::format("{} min {:02} s", whole / 60, whole % 60);
    return fmt::format("{} h {:02} min", whole / 3600, whole / 60 % 60);
}

}  // namespace gripscan::ui
