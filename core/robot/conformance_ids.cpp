// Checks of ids and refusals: what must not move the arm.
#include "core/robot/command_ids.h"
#include "core/robot/conformance_turns.h"

namespace gripscan::gsp {

/// Where the arm stands is asked for under the lowest id: taken, or refused with the last one.
Verdict learns_the_last_id(Probe& probe) {
    TurnJoint6 here = next_turn(probe, 0.0);
    const std::string line = probe.motion.ask(encode(Request(here)));
    const auto reply = decode_reply(line);
    const auto* refusal = reply ? std::get_if<Failure>(&*reply) : nullptr;
    if (refusal && refusal->code == ErrorCode::kStaleId) {
        const auto last = last_id_in(refusal->text);
        if (!last) return {CheckOutcome::kFailed, line};
        if (*last >= kGreatestId) {
            return {CheckOutcome::kFailed, line + " | its ids are used up: clear its last id"};
        }
        probe.last_id = *last;
        return {CheckOutcome::kPassed, line};
    }
    if (!is_reply<Accepted>(line)) return {CheckOutcome::kFailed, line};
    const std::string end = end_of_turn(probe);
    return passed_if(is_done_at(end, here), end);
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
    // To where it stands: a controller that takes such a speed must not use it here.
    const auto here_deg = joint6_deg(probe);
    if (!here_deg) return {CheckOutcome::kFailed, "no position"};
    Verdict verdict;
    for (const double speed_percent : {0.0, 101.0}) {
        verdict =
            is_refused(probe, {++probe.last_id, *here_deg, speed_percent}, ErrorCode::kSpeedRange);
        if (verdict.outcome != CheckOutcome::kPassed) break;
    }
    return verdict;
}

}  // namespace gripscan::gsp
