#include "core/robot/conformance_turns.h"

#include <cmath>
#include <thread>

namespace gripscan::gsp {

std::optional<double> joint6_deg(Probe& probe) {
    const auto reply = probe.monitor.ask_for<PositionReply>(AskPosition{});
    return reply ? reply->position.joints_deg[5] : std::nullopt;
}

void wait_until_it_stands(Probe& probe) {
    const auto limit = deadline_in(probe.settings.motion_limit);
    while (std::chrono::steady_clock::now() < limit) {
        const auto state = probe.monitor.ask_for<StateReply>(AskState{});
        if (!state || state->moving != true) return;
        std::this_thread::sleep_for(std::chrono::milliseconds(20));
    }
}

bool stands_at(Probe& probe, std::optional<double> angle_deg) {
    std::this_thread::sleep_for(probe.settings.split_pause);
    const auto state = probe.monitor.ask_for<StateReply>(AskState{});
    const auto now_deg = joint6_deg(probe);
    return state && state->moving == false && angle_deg && now_deg &&
           std::abs(*now_deg - *angle_deg) < kStillTolerance_deg;
}

TurnJoint6 next_turn(Probe& probe, double steps) {
    const double start_deg = probe.start->joints_deg[5].value_or(0.0);
    const double angle_deg = start_deg + probe.direction * steps * probe.settings.step_deg;
    return {++probe.last_id, std::round(angle_deg * 1e4) / 1e4, probe.settings.speed_percent};
}

std::string end_of_turn(Probe& probe) {
    const auto line = probe.motion.next(probe.settings.motion_limit);
    if (!line) probe.motion.close();
    return line ? *line : line.error().what;
}

std::string trouble_with_acceptance(Probe& probe, const TurnJoint6& turn) {
    std::string line = probe.motion.ask(encode(Request(turn)));
    return line == encode(Reply(Accepted{turn.id})) ? std::string() : line;
}

bool is_done_at(std::string_view line, const TurnJoint6& turn) {
    const auto reply = decode_reply(line);
    const auto* done = reply ? std::get_if<Done>(&*reply) : nullptr;
    return done && done->id == turn.id && done->position.joints_deg[5] &&
           std::abs(*done->position.joints_deg[5] - turn.angle_deg) < kEndTolerance_deg;
}

Verdict make(Probe& probe, const TurnJoint6& turn) {
    if (const auto trouble = trouble_with_acceptance(probe, turn); !trouble.empty()) {
        return {CheckOutcome::kFailed, trouble};
    }
    const std::string line = end_of_turn(probe);
    if (!is_done_at(line, turn)) return {CheckOutcome::kFailed, line};
    probe.turn = turn;
    probe.done_line = line;
    const Done done = std::get<Done>(*decode_reply(line));
    if (!stands_at(probe, done.position.joints_deg[5])) {
        return {CheckOutcome::kFailed, line + " | joint 6 does not stand there"};
    }
    return {CheckOutcome::kPassed, line};
}

Verdict is_refused(Probe& probe, const TurnJoint6& turn, ErrorCode code) {
    const auto before_deg = joint6_deg(probe);
    const std::string line = probe.motion.ask(encode(Request(turn)));
    stop_if_taken(probe, line);
    const bool still = stands_at(probe, before_deg);
    if (is_reply<Accepted>(line)) (void)end_of_turn(probe);
    const bool names_last = code != ErrorCode::kStaleId || line.find(" last=") != std::string::npos;
    return passed_if(is_error(line, turn.id, code) && still && names_last, line);
}

}  // namespace gripscan::gsp
