// Checks that move nothing: greeting, questions, framing, lines that make no sense.
#include <fmt/format.h>

#include <cmath>
#include <thread>

#include "core/base/units.h"
#include "core/robot/conformance_probe.h"
#include "core/robot/gsp_reading.h"
#include "core/robot/gsp_words.h"
#include "core/robot/kinematics.h"

namespace gripscan::gsp {
namespace {

Verdict greets(ProbeLink& link) {
    const std::string line = link.ask("HELLO 1");
    const auto reply = decode_reply(line);
    const auto* hello = reply ? std::get_if<HelloReply>(&*reply) : nullptr;
    return passed_if(hello && hello->axes == kAxes && hello->version.starts_with("GSP/1."), line);
}
Verdict greets_motion(Probe& probe) {
    return greets(probe.motion);
}
Verdict greets_monitor(Probe& probe) {
    return greets(probe.monitor);
}

Verdict refuses_version(Probe& probe) {
    const std::string line = probe.motion.ask("HELLO 99");
    return passed_if(is_error(line, 0, ErrorCode::kVersion), line);
}

template <typename Wanted>
Verdict answers_on_both(Probe& probe, std::string_view request) {
    const std::string motion = probe.motion.ask(request);
    const std::string monitor = probe.monitor.ask(request);
    if (!is_reply<Wanted>(motion)) return {CheckOutcome::kFailed, "motion: " + motion};
    return passed_if(is_reply<Wanted>(monitor), "monitor: " + monitor);
}
Verdict tells_state(Probe& probe) {
    return answers_on_both<StateReply>(probe, "STATE");
}
Verdict tells_position(Probe& probe) {
    return answers_on_both<PositionReply>(probe, "POS");
}

Verdict knows_joints_in_range(Probe& probe) {
    const std::string line = probe.monitor.ask("POS");
    const auto reply = decode_reply(line);
    const auto* position = reply ? std::get_if<PositionReply>(&*reply) : nullptr;
    if (!position) return {CheckOutcome::kFailed, line};
    const auto reading = reading_from(position->position);
    if (!reading) return {CheckOutcome::kFailed, reading.error().message};
    const Status in_range = check_joint_ranges(reading->joints_rad);
    return passed_if(in_range.has_value(), in_range ? line : in_range.error().message);
}

Verdict clock_runs(Probe& probe) {
    const auto first = probe.monitor.ask_for<PositionReply>(AskPosition{});
    std::this_thread::sleep_for(probe.settings.split_pause);
    const auto second = probe.monitor.ask_for<PositionReply>(AskPosition{});
    if (!first || !second) return {CheckOutcome::kFailed, "no position"};
    const auto t1 = first->position.time_ms;
    const auto t2 = second->position.time_ms;
    if (!t1 || !t2) return {CheckOutcome::kNoted, "the controller tells no time"};
    return passed_if(*t2 > *t1, fmt::format("{} ms, then {} ms", *t1, *t2));
}

/// The controller's pose is that of its own tool and frame, so a difference is no fault.
Verdict pose_against_joints(Probe& probe) {
    const auto reply = probe.monitor.ask_for<PositionReply>(AskPosition{});
    const auto reading = reply ? reading_from(reply->position) : RobotResult<RobotReading>();
    if (!reply || !reading) return skipped("no position");
    const Pose difference = tool_pose(reading->joints_rad).inverse() * reading->T_world_tool;
    return {CheckOutcome::kNoted,
            fmt::format("user frame {}, tool {}: {:.3f} mm and {:.4f} deg from the flange's pose "
                        "by forward kinematics",
                        word_or_dash(reply->position.uframe), word_or_dash(reply->position.utool),
                        difference.translation().norm() * kMmPerM,
                        deg_from_rad(rotation_angle_rad(difference.linear())))};
}

Verdict refuses_unknown(Probe& probe) {
    const std::string line = probe.motion.ask("JUMP 3");
    return passed_if(is_error(line, 0, ErrorCode::kUnknownRequest), line);
}

/// Where joint 6 stands: what asks for a turn here asks for this angle, so that a controller that
/// obeys against the rules moves nothing.
std::optional<std::string> here(Probe& probe) {
    const auto reply = probe.monitor.ask_for<PositionReply>(AskPosition{});
    if (!reply || !reply->position.joints_deg[5]) return std::nullopt;
    return fixed_text(*reply->position.joints_deg[5]);
}

Verdict refuses_malformed(Probe& probe) {
    const auto angle = here(probe);
    if (!angle) return skipped("where joint 6 stands is not known");
    std::string line;
    for (const std::string& request :
         {std::string("J6ABS"), "J6ABS 1 " + *angle, "J6ABS x " + *angle + " 1",
          "J6ABS 1 " + *angle + "x 1", "J6ABS 1 " + *angle + " 1 4", "J6ABS 0 " + *angle + " 1",
          std::string("HELLO")}) {
        line = probe.motion.ask(request);
        stop_if_taken(probe, line);
        if (!is_error(line, 1, ErrorCode::kMalformed, true)) {
            return {CheckOutcome::kFailed, fmt::format("'{}': {}", request, line)};
        }
    }
    return {CheckOutcome::kPassed, line};
}

Verdict monitor_moves_nothing(Probe& probe) {
    const auto angle = here(probe);
    if (!angle) return skipped("where joint 6 stands is not known");
    const std::string line = probe.monitor.ask("J6ABS 1 " + *angle + " 1");
    stop_if_taken(probe, line);
    return passed_if(is_error(line, 1, ErrorCode::kUnknownRequest, true), line);
}

Verdict stops_at_rest(Probe& probe) {
    const std::string line = probe.monitor.ask("STOP");
    return passed_if(is_reply<StopReply>(line), line);
}

Verdict spaces_do_not_matter(Probe& probe) {
    const std::string line = probe.motion.ask("  HELLO    1  ");
    return passed_if(is_reply<HelloReply>(line), line);
}

Verdict takes_split_lines(Probe& probe) {
    for (const char* part : {"S", "TA", "TE\r", "\n"}) {
        probe.motion.send(part);
        std::this_thread::sleep_for(probe.settings.split_pause);
    }
    const auto line = probe.motion.next(probe.settings.reply_limit);
    return passed_if(line && is_reply<StateReply>(*line), line ? *line : line.error().what);
}

Verdict takes_joined_lines(Probe& probe) {
    probe.motion.send("STATE\r\nPOS\r\nHELLO 1\r\n");
    const auto first = probe.motion.next(probe.settings.reply_limit);
    const auto second = probe.motion.next(probe.settings.reply_limit);
    const auto third = probe.motion.next(probe.settings.reply_limit);
    const auto text = [](const auto& line) { return line ? *line : line.error().what; };
    const bool holds = first && is_reply<StateReply>(*first) && second &&
                       is_reply<PositionReply>(*second) && third && is_reply<HelloReply>(*third);
    return passed_if(holds, fmt::format("{} | {} | {}", text(first), text(second), text(third)));
}

Verdict takes_any_line_end(Probe& probe) {
    for (const char* bytes : {"HELLO 1\r", "HELLO 1\n", "\r\n\r\n\n\rHELLO 1\r\n"}) {
        probe.motion.send(bytes);
        const auto line = probe.motion.next(probe.settings.reply_limit);
        if (!line || !is_reply<HelloReply>(*line)) {
            return {CheckOutcome::kFailed, line ? *line : line.error().what};
        }
    }
    const auto more = probe.motion.next(probe.settings.split_pause);
    return passed_if(!more, more ? "an empty line was answered with " + *more : "one reply each");
}

Verdict survives_long_lines(Probe& probe) {
    std::string line;
    for (const std::size_t length : {kLongestLine + 1, kLongestBearable}) {
        line = probe.motion.ask(std::string(length, 'X'));
        if (!is_error(line, 0, ErrorCode::kMalformed)) return {CheckOutcome::kFailed, line};
        const std::string after = probe.motion.ask("HELLO 1");
        if (!is_reply<HelloReply>(after)) {
            return {CheckOutcome::kFailed, fmt::format("after {} characters: {}", length, after)};
        }
    }
    return {CheckOutcome::kPassed, line};
}

/// Sends what no link survives, and expects to be welcome again afterwards.
Verdict closes_after(Probe& probe, std::string_view bytes) {
    if (!is_reply<HelloReply>(probe.motion.ask("HELLO 1"))) return skipped("no link to try it on");
    probe.motion.send(bytes);
    const auto line = probe.motion.next(probe.settings.reply_limit);
    const bool closed = !line && line.error().kind == NoLine::Kind::kClosed;
    const std::string seen = line ? *line : line.error().what;
    probe.motion.close();
    const std::string again = probe.motion.ask("HELLO 1");
    return passed_if(closed && is_reply<HelloReply>(again),
                     fmt::format("{}, then {}", seen, again));
}
Verdict closes_after_endless_line(Probe& probe) {
    return closes_after(probe, std::string(kLongestBearable + 50, 'X').append(kLineEnd));
}
Verdict closes_after_other_bytes(Probe& probe) {
    return closes_after(probe, "STATE \xC3\x9F\r\n");
}

Verdict takes_the_next_client(Probe& probe) {
    std::string line;
    for (ProbeLink* link : {&probe.motion, &probe.monitor}) {
        link->close();
        line = link->ask("HELLO 1");
        if (!is_reply<HelloReply>(line)) return {CheckOutcome::kFailed, line};
    }
    return {CheckOutcome::kPassed, line};
}

}  // namespace

std::vector<CheckRow> still_checks() {
    return {
        {"hello.motion", "OK HELLO <model> 6 GSP/1.<n>", greets_motion},
        {"hello.monitor", "OK HELLO <model> 6 GSP/1.<n>", greets_monitor},
        {"hello.version", "ERR 0 102 to HELLO 99", refuses_version},
        {"state", "OK STATE with seven fields on both links", tells_state},
        {"position", "OK POS with fifteen fields on both links", tells_position},
        {"position.joints", "six known joints, each in its range", knows_joints_in_range},
        {"position.time", "t_ms rises", clock_runs},
        {"position.pose", "nothing", pose_against_joints},
        {"unknown", "ERR 0 101 to a request that is none", refuses_unknown},
        {"malformed", "ERR <id or 0> 100, nothing moves", refuses_malformed},
        {"monitor.turn", "ERR <id or 0> 101 to J6ABS on the monitor link", monitor_moves_nothing},
        {"monitor.stop", "OK STOP, also when nothing moves", stops_at_rest},
        {"frame.spaces", "any number of spaces between words", spaces_do_not_matter},
        {"frame.split", "a line in several segments is one line", takes_split_lines},
        {"frame.joined", "several lines in one segment are answered in order", takes_joined_lines},
        {"frame.ends", "CR, LF, CR LF end a line; empty lines are skipped", takes_any_line_end},
        {"frame.long", "ERR 0 100 to 201 … 254 characters, the link stays", survives_long_lines},
        {"frame.endless", "more than 254 characters close the link", closes_after_endless_line},
        {"frame.ascii", "bytes that are not ASCII close the link", closes_after_other_bytes},
        {"reconnect", "a new client is greeted on both links", takes_the_next_client},
    };
}

}  // namespace gripscan::gsp
