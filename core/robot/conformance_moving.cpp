// Checks that turn joint 6: absolute targets, ids, refusals, STOP, what the monitor sees meanwhile.
#include <fmt/format.h>

#include <cmath>
#include <thread>

#include "core/base/units.h"
#include "core/robot/conformance_probe.h"
#include "core/robot/gsp_reading.h"
#include "core/robot/kinematics.h"

namespace gripscan::gsp {
namespace {

constexpr double kTarget_deg = 0.05;
constexpr double kOtherJoint_deg = 0.02;

std::optional<double> joint6_deg(Probe& probe) {
    const auto reply = probe.monitor.ask_for<PositionReply>(AskPosition{});
    return reply ? reply->position.joints_deg[5] : std::nullopt;
}

/// Does joint 6 stand at that angle, also a moment later?
bool stands_at(Probe& probe, std::optional<double> angle_deg) {
    std::this_thread::sleep_for(probe.settings.split_pause);
    const auto state = probe.monitor.ask_for<StateReply>(AskState{});
    const auto now_deg = joint6_deg(probe);
    return state && state->moving == false && angle_deg && now_deg &&
           std::abs(*now_deg - *angle_deg) < kOtherJoint_deg;
}

/// `steps` away from where the arm stood first.
TurnJoint6 next_turn(Probe& probe, double steps) {
    const double start_deg = probe.start->joints_deg[5].value_or(0.0);
    const double angle_deg = start_deg + probe.direction * steps * probe.settings.step_deg;
    return {++probe.last_id, std::round(angle_deg * 1e4) / 1e4, probe.settings.speed_percent};
}

/// The line that ends a turn whose ACC has come.
std::string end_of_turn(Probe& probe) {
    const auto line = probe.motion.next(probe.settings.motion_limit);
    if (!line) probe.motion.close();
    return line ? *line : line.error().what;
}

/// Empty if ACC came, else what came.
std::string trouble_with_acceptance(Probe& probe, const TurnJoint6& turn) {
    std::string line = probe.motion.ask(encode(Request(turn)));
    return line == encode(Reply(Accepted{turn.id})) ? std::string() : line;
}

bool is_done_at(std::string_view line, const TurnJoint6& turn) {
    const auto reply = decode_reply(line);
    const auto* done = reply ? std::get_if<Done>(&*reply) : nullptr;
    return done && done->id == turn.id && done->position.joints_deg[5] &&
           std::abs(*done->position.joints_deg[5] - turn.angle_deg) < kTarget_deg;
}

/// Makes a turn from beginning to end.
Verdict make(Probe& probe, const TurnJoint6& turn) {
    if (const auto trouble = trouble_with_acceptance(probe, turn); !trouble.empty()) {
        return {CheckOutcome::kFailed, trouble};
    }
    const std::string line = end_of_turn(probe);
    const bool done = is_done_at(line, turn);
    if (done) {
        probe.turn = turn;
        probe.done_line = line;
    }
    return passed_if(done, line);
}

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

/// Where the arm stands is asked for under the lowest id: taken, or refused with the last one.
Verdict learns_the_last_id(Probe& probe) {
    TurnJoint6 here = next_turn(probe, 0.0);
    const std::string line = probe.motion.ask(encode(Request(here)));
    const auto reply = decode_reply(line);
    const auto* refusal = reply ? std::get_if<Failure>(&*reply) : nullptr;
    if (refusal && refusal->code == ErrorCode::kStaleId) {
        const auto last = last_id_in(refusal->text);
        if (last) probe.last_id = *last;
        return passed_if(last.has_value(), line);
    }
    if (!is_reply<Accepted>(line)) return {CheckOutcome::kFailed, line};
    const std::string end = end_of_turn(probe);
    return passed_if(is_done_at(end, here), end);
}

Verdict turns(Probe& probe) {
    return make(probe, next_turn(probe, 1.0));
}

Verdict repeats_without_moving(Probe& probe) {
    if (!probe.turn) return skipped("no turn was made");
    const auto before_deg = joint6_deg(probe);
    if (const auto trouble = trouble_with_acceptance(probe, *probe.turn); !trouble.empty()) {
        return {CheckOutcome::kFailed, trouble};
    }
    const std::string line = end_of_turn(probe);
    const bool still = stands_at(probe, before_deg);
    return passed_if(still && line == probe.done_line, line);
}

Verdict is_refused(Probe& probe, const TurnJoint6& turn, ErrorCode code) {
    const auto before_deg = joint6_deg(probe);
    const std::string line = probe.motion.ask(encode(Request(turn)));
    const bool still = stands_at(probe, before_deg);
    if (is_reply<Accepted>(line)) (void)end_of_turn(probe);
    const bool names_last = code != ErrorCode::kStaleId || line.find(" last=") != std::string::npos;
    return passed_if(is_error(line, turn.id, code) && still && names_last, line);
}

Verdict refuses_other_arguments(Probe& probe) {
    if (!probe.turn) return skipped("no turn was made");
    TurnJoint6 other = *probe.turn;
    other.angle_deg -= probe.direction * probe.settings.step_deg / 2.0;
    return is_refused(probe, other, ErrorCode::kStaleId);
}

Verdict refuses_old_ids(Probe& probe) {
    if (!probe.turn || probe.turn->id < 2) return skipped("no turn with an id above 1 was made");
    TurnJoint6 old = *probe.turn;
    --old.id;
    return is_refused(probe, old, ErrorCode::kStaleId);
}

Verdict refuses_far_targets(Probe& probe) {
    TurnJoint6 turn = next_turn(probe, 0.0);
    turn.angle_deg = probe.direction * 400.0;
    return is_refused(probe, turn, ErrorCode::kTargetRange);
}

Verdict refuses_speeds(Probe& probe) {
    TurnJoint6 turn = next_turn(probe, 1.0);
    turn.speed_percent = 0.0;
    const Verdict slow = is_refused(probe, turn, ErrorCode::kSpeedRange);
    if (slow.outcome != CheckOutcome::kPassed) return slow;
    turn = next_turn(probe, 1.0);
    turn.speed_percent = 101.0;
    return is_refused(probe, turn, ErrorCode::kSpeedRange);
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
        const bool left = std::abs(*now_deg - begin_deg) > kTarget_deg;
        const bool arrived = std::abs(*now_deg - turn.angle_deg) < kTarget_deg;
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
        stands_at(probe, end_deg) && std::abs(*end_deg - turn.angle_deg) > kTarget_deg;
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
    return passed_if(largest_deg <= kOtherJoint_deg, fmt::format("{:.4f} deg", largest_deg));
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
        {"move.turn", "ACC, then DONE with joint 6 at its target", turns},
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
