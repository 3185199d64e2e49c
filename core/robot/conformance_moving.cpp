// Checks that turn joint 6: absolute targets, STOP, what the monitor sees meanwhile, a lost link.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <thread>

#include "core/base/units.h"
#include "core/robot/conformance_turns.h"
#include "core/robot/gsp_reading.h"
#include "core/robot/kinematics.h"

namespace gripscan::gsp {
namespace {

Verdict is_ready(Probe& probe) {
    const std::string line = probe.monitor.ask("STATE");
    const auto state = probe.monitor.ask_for<StateReply>(AskState{});
    const auto position = probe.monitor.ask_for<PositionReply>(AskPosition{});
    const bool ready = state && state->automatic == true && state->servo_on == true &&
                       state->emergency_stop != true && state->fault != true &&
                       state->moving == false && position && position->position.joints_deg[5];
    if (ready) {
        probe.start = position->position;
        const double room_deg = 2.0 * probe.settings.step_deg;
        probe.direction = *probe.start->joints_deg[5] + room_deg < 360.0 ? 1.0 : -1.0;
    }
    return passed_if(ready, line);
}

Verdict turns(Probe& probe) {
    return make(probe, next_turn(probe, 1.0));
}

/// Back to the start, watched on the monitor link, with another command in between.
struct Watched {
    int between = 0;  ///< positions on the way
    bool moving_told = false;
};
Watched watch(Probe& probe, const TurnJoint6& turn, double begin_deg) {
    Watched seen;
    const auto limit = deadline_in(probe.settings.motion_limit);
    while (std::chrono::steady_clock::now() < limit) {
        const auto state = probe.monitor.ask_for<StateReply>(AskState{});
        const auto now_deg = joint6_deg(probe);
        if (!state || !now_deg) break;
        if (state->moving == true) seen.moving_told = true;
        const bool left = std::abs(*now_deg - begin_deg) > kEndTolerance_deg;
        const bool arrived = std::abs(*now_deg - turn.angle_deg) < kEndTolerance_deg;
        if (left && !arrived) ++seen.between;
        if (arrived && state->moving != true) break;
        std::this_thread::sleep_for(std::chrono::milliseconds(20));
    }
    return seen;
}

Verdict can_be_watched(Probe& probe) {
    const double begin_deg = joint6_deg(probe).value_or(0.0);
    const TurnJoint6 turn = next_turn(probe, 0.0);
    if (const auto trouble = trouble_with_acceptance(probe, turn); !trouble.empty()) {
        return {CheckOutcome::kFailed, trouble};
    }
    const Watched seen = watch(probe, turn, begin_deg);
    const std::string line = end_of_turn(probe);
    return passed_if(is_done_at(line, turn) && seen.between >= 2 && seen.moving_told,
                     fmt::format("{} positions on the way, moving {}; {}", seen.between,
                                 seen.moving_told ? "told" : "not told", line));
}

Verdict is_busy(Probe& probe) {
    const TurnJoint6 turn = next_turn(probe, 1.0);
    if (const auto trouble = trouble_with_acceptance(probe, turn); !trouble.empty()) {
        return {CheckOutcome::kFailed, trouble};
    }
    const TurnJoint6 second = next_turn(probe, 1.0);
    const std::string line = probe.motion.ask(encode(Request(second)));
    const std::string end = end_of_turn(probe);
    if (is_done_at(end, turn)) {
        probe.turn = turn;
        probe.done_line = end;
    }
    return passed_if(is_error(line, second.id, ErrorCode::kBusy) && is_done_at(end, turn),
                     fmt::format("{} | {}", line, end));
}

Verdict stops(Probe& probe) {
    const TurnJoint6 turn = next_turn(probe, 0.0);
    if (const auto trouble = trouble_with_acceptance(probe, turn); !trouble.empty()) {
        return {CheckOutcome::kFailed, trouble};
    }
    std::this_thread::sleep_for(probe.settings.split_pause);
    const std::string stop = probe.monitor.ask("STOP");
    const std::string end = end_of_turn(probe);
    const auto end_deg = joint6_deg(probe);
    const bool still =
        stands_at(probe, end_deg) && std::abs(*end_deg - turn.angle_deg) > kEndTolerance_deg;
    return passed_if(
        is_reply<StopReply>(stop) && is_error(end, turn.id, ErrorCode::kStopped) && still,
        fmt::format("{} | {} | joint 6 {}", stop, end,
                    still ? "stands short of its target" : "does not stand short"));
}

Verdict survives_a_lost_link(Probe& probe) {
    const TurnJoint6 turn = next_turn(probe, 1.5);
    if (const auto trouble = trouble_with_acceptance(probe, turn); !trouble.empty()) {
        return {CheckOutcome::kFailed, trouble};
    }
    probe.motion.close();
    if (const auto opened = probe.motion.open(); !opened) {
        return {CheckOutcome::kFailed, opened.error().message};
    }
    // A controller may take the new client only once its arm stands.
    probe.motion.send_line(encode(Request(turn)));
    const auto accepted = probe.motion.next(probe.settings.motion_limit);
    if (!accepted || *accepted != encode(Reply(Accepted{turn.id}))) {
        return {CheckOutcome::kFailed, accepted ? *accepted : accepted.error().what};
    }
    const std::string end = end_of_turn(probe);
    if (!is_done_at(end, turn)) return {CheckOutcome::kFailed, end};
    probe.motion.close();
    TurnJoint6 other = turn;
    other.angle_deg -= probe.direction * probe.settings.step_deg;
    const Verdict remembered = is_refused(probe, other, ErrorCode::kStaleId);
    return {remembered.outcome, fmt::format("{} | {}", end, remembered.seen)};
}

Verdict returns(Probe& probe) {
    return make(probe, next_turn(probe, 0.0));
}

Verdict other_joints_stand(Probe& probe) {
    const auto now = probe.monitor.ask_for<PositionReply>(AskPosition{});
    if (!now) return {CheckOutcome::kFailed, "no position"};
    double largest_deg = 0.0;
    for (std::size_t i = 0; i < 5; ++i) {
        largest_deg = std::max(largest_deg, std::abs(now->position.joints_deg[i].value_or(1e9) -
                                                     probe.start->joints_deg[i].value_or(-1e9)));
    }
    return passed_if(largest_deg <= kStillTolerance_deg, fmt::format("{:.4f} deg", largest_deg));
}

/// The tool's pose on the flange, whatever it is, does not depend on joint 6.
Verdict pose_follows_joints(Probe& probe) {
    const auto done = decode_reply(probe.done_line);
    const auto* turned = done ? std::get_if<Done>(&*done) : nullptr;
    const auto tool_of = [](const Position& p) -> std::optional<Pose> {
        const bool complete = std::all_of(p.xyzwpr.begin(), p.xyzwpr.end(),
                                          [](const auto& value) { return value.has_value(); });
        const auto reading = reading_from(p);
        if (!complete || p.uframe != 0 || !reading) return std::nullopt;
        return tool_pose(reading->joints_rad).inverse() * reading->T_world_tool;
    };
    const auto before = tool_of(*probe.start);
    const auto after = turned ? tool_of(turned->position) : std::nullopt;
    if (!before || !after) return skipped("poses are complete in user frame 0 only");
    const Pose difference = before->inverse() * *after;
    const double mm = difference.translation().norm() * kMmPerM;
    const double deg = deg_from_rad(rotation_angle_rad(difference.linear()));
    return passed_if(mm < 0.1 && deg < 0.05, fmt::format("{:.4f} mm, {:.4f} deg", mm, deg));
}

}  // namespace

std::vector<CheckRow> moving_checks() {
    return {
        {"move.ready", "AUTO, servo on, no emergency stop, no fault, standing", is_ready},
        {"move.ids", "ACC to a new id, or ERR 304 last=<n>", learns_the_last_id},
        {"move.turn", "ACC, then DONE with joint 6 standing at its target", turns},
        {"move.pose", "the pose turns as forward kinematics says", pose_follows_joints},
        {"move.repeat", "the same id: ACC, the stored DONE, no motion", repeats_without_moving},
        {"move.conflict", "the same id, another angle: ERR <id> 304 last=<n>",
         refuses_other_arguments},
        {"move.stale", "a lower id: ERR <id> 304 last=<n>", refuses_old_ids},
        {"move.range", "400 deg: ERR <id> 300, no motion", refuses_far_targets},
        {"move.speed", "0 % and 101 %: ERR <id> 302, no motion", refuses_speeds},
        {"move.watch", "STATE and POS on the monitor link while it moves", can_be_watched},
        {"move.busy", "another id meanwhile: ERR <id> 303; the first ends with DONE", is_busy},
        {"move.stop", "OK STOP, then ERR <id> 410, short of the target", stops},
        {"move.lost", "the link lost after ACC: the same id ends with DONE, and is remembered",
         survives_a_lost_link},
        {"move.return", "joint 6 goes back to where it was", returns},
        {"move.others", "joints 1 … 5 where they were, to 0.02 deg", other_joints_stand},
    };
}

}  // namespace gripscan::gsp
