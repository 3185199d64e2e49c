#include "core/robot/gsp_message.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "core/robot/gsp_words.h"
#include "core/robot/line_framer.h"

namespace gripscan::gsp {
namespace {

// Writing. Each message is its words; the last may be free text.

struct RequestText {
    std::string operator()(const Hello& m) const { return fmt::format("HELLO {}", m.version); }
    std::string operator()(const AskState&) const { return "STATE"; }
    std::string operator()(const AskPosition&) const { return "POS"; }
    std::string operator()(const TurnJoint6& m) const {
        return fmt::format("J6ABS {} {} {}", m.id, fixed_text(m.angle_deg),
                           short_text(m.speed_percent));
    }
    std::string operator()(const Stop&) const { return "STOP"; }
};

std::string position_text(const Position& p) {
    std::string text = fmt::format("POS {}", word_or_dash(p.time_ms));
    for (const auto& joint : p.joints_deg) text.append(" ").append(word_or_dash(joint));
    for (const auto& value : p.xyzwpr) text.append(" ").append(word_or_dash(value));
    return text + fmt::format(" {} {}", word_or_dash(p.uframe), word_or_dash(p.utool));
}

struct ReplyText {
    std::string operator()(const HelloReply& m) const {
        return fmt::format("OK HELLO {} {} {}", m.model.empty() ? "-" : m.model, m.axes, m.version);
    }
    std::string operator()(const StateReply& m) const {
        return fmt::format("OK STATE {} {} {} {} {} {} {}", word_or_dash(m.automatic),
                           word_or_dash(m.servo_on), word_or_dash(m.emergency_stop),
                           word_or_dash(m.fault), word_or_dash(m.moving),
                           word_or_dash(m.override_percent), m.alarm.empty() ? "-" : m.alarm);
    }
    std::string operator()(const PositionReply& m) const {
        return "OK " + position_text(m.position);
    }
    std::string operator()(const Accepted& m) const { return fmt::format("OK ACC {}", m.id); }
    std::string operator()(const Done& m) const {
        return fmt::format("DONE {} {}", m.id, position_text(m.position));
    }
    std::string operator()(const StopReply&) const { return "OK STOP"; }
    std::string operator()(const Failure& m) const {
        return fmt::format("ERR {} {} {}", m.id, static_cast<int>(m.code), m.text);
    }
};

/// What may travel: printable ASCII, not too long, no blank at its end.
std::string line_of(std::string text) {
    std::replace_if(
        text.begin(), text.end(), [](char c) { return c < ' ' || c > '~'; }, '?');
    text.resize(std::min(text.size(), kLongestLine));
    while (text.ends_with(' ')) text.pop_back();
    return text;
}

// Reading. Each takes the words after the ones that name the message.

constexpr int kAnyId = std::numeric_limits<int>::max();

std::optional<Request> hello(WordReader words) {
    const auto version = words.whole(0, 9999);
    if (!version || !words.at_end()) return std::nullopt;
    return Hello{*version};
}

std::optional<Request> turn(WordReader words) {
    const auto id = words.whole(1, kAnyId);
    const auto angle = words.number();
    const auto speed = words.number();
    if (!id || !angle || !speed || !words.at_end()) return std::nullopt;
    return TurnJoint6{*id, *angle, *speed};
}

template <typename Message>
std::optional<Request> bare(WordReader words) {
    if (!words.at_end()) return std::nullopt;
    return Message{};
}

std::optional<Reply> hello_reply(WordReader words) {
    const auto model = words.word();
    const auto axes = words.whole(0, 99);
    const auto version = words.word();
    if (!model || !axes || !version || !words.at_end()) return std::nullopt;
    return HelloReply{std::string(*model), *axes, std::string(*version)};
}

std::optional<Reply> state_reply(WordReader words) {
    StateReply m;
    for (auto* flag : {&m.automatic, &m.servo_on, &m.emergency_stop, &m.fault, &m.moving}) {
        const auto value = words.known(&WordReader::whole, 0, 1);
        if (!value) return std::nullopt;
        if (*value) *flag = **value == 1;
    }
    const auto override_percent = words.known(&WordReader::whole, 0, 100);
    const std::string_view alarm = words.rest();
    if (!override_percent || alarm.empty()) return std::nullopt;
    m.override_percent = *override_percent;
    if (alarm != "-") m.alarm = alarm;
    return m;
}

std::optional<Position> position(WordReader words) {
    Position p;
    const auto time = words.known(&WordReader::whole64);
    if (!time) return std::nullopt;
    p.time_ms = *time;
    for (auto* values : {&p.joints_deg, &p.xyzwpr}) {
        for (auto& value : *values) {
            const auto number = words.known(&WordReader::number);
            if (!number) return std::nullopt;
            value = *number;
        }
    }
    for (auto* frame : {&p.uframe, &p.utool}) {
        const auto number = words.known(&WordReader::whole, 0, 99);
        if (!number) return std::nullopt;
        *frame = *number;
    }
    if (!words.at_end()) return std::nullopt;
    return p;
}

std::optional<Reply> ok_reply(WordReader words) {
    const auto name = words.word();
    if (!name) return std::nullopt;
    if (*name == "HELLO") return hello_reply(words);
    if (*name == "STATE") return state_reply(words);
    if (*name == "POS") {
        const auto p = position(words);
        return p ? std::optional<Reply>(PositionReply{*p}) : std::nullopt;
    }
    if (*name == "STOP") return words.at_end() ? std::optional<Reply>(StopReply{}) : std::nullopt;
    if (*name != "ACC") return std::nullopt;
    const auto id = words.whole(1, kAnyId);
    return id && words.at_end() ? std::optional<Reply>(Accepted{*id}) : std::nullopt;
}

std::optional<Reply> done_reply(WordReader words) {
    const auto id = words.whole(1, kAnyId);
    if (!id || words.word() != "POS") return std::nullopt;
    const auto p = position(words);
    return p ? std::optional<Reply>(Done{*id, *p}) : std::nullopt;
}

std::optional<Reply> error_reply(WordReader words) {
    const auto id = words.whole(0, kAnyId);
    const auto code = words.whole(100, 999);
    if (!id || !code) return std::nullopt;
    return Failure{*id, ErrorCode{*code}, std::string(words.rest())};
}

/// The id of a turn that cannot be read otherwise; 0 where there is none.
int id_of_turn(WordReader words) {
    return words.whole(1, kAnyId).value_or(0);
}

std::optional<Reply> any_reply(std::string_view line) {
    if (!is_printable(line) || line.size() > kLongestLine) return std::nullopt;
    WordReader words(line);
    const auto name = words.word();
    if (name == "OK") return ok_reply(words);
    if (name == "DONE") return done_reply(words);
    if (name == "ERR") return error_reply(words);
    return std::nullopt;
}

}  // namespace

std::string encode(const Request& request) {
    return line_of(std::visit(RequestText{}, request));
}
std::string encode(const Reply& reply) {
    return line_of(std::visit(ReplyText{}, reply));
}

tl::expected<Request, Failure> decode_request(std::string_view line) {
    const auto failed = [](int id, ErrorCode code) {
        return tl::unexpected<Failure>(Failure{id, code, std::string(words_of(code))});
    };
    if (line.size() > kLongestLine) return tl::unexpected<Failure>(too_long());
    if (!is_printable(line)) return failed(0, ErrorCode::kMalformed);
    WordReader words(line);
    const auto name = words.word();
    const auto or_malformed = [&](std::optional<Request> request,
                                  int id = 0) -> tl::expected<Request, Failure> {
        if (!request) return failed(id, ErrorCode::kMalformed);
        return *request;
    };
    if (name == "HELLO") return or_malformed(hello(words));
    if (name == "STATE") return or_malformed(bare<AskState>(words));
    if (name == "POS") return or_malformed(bare<AskPosition>(words));
    if (name == "STOP") return or_malformed(bare<Stop>(words));
    if (name == "J6ABS") return or_malformed(turn(words), id_of_turn(words));
    return failed(0, ErrorCode::kUnknownRequest);
}

RobotResult<Reply> decode_reply(std::string_view line) {
    if (auto reply = any_reply(line)) return *std::move(reply);
    return tl::unexpected<RobotError>(
        RobotError{RobotFault::kProtocol, 0, 0,
                   fmt::format("'{}' is no reply of GSP/1; is this port the gripscan server of the "
                               "controller?",
                               printable(line))});
}

Failure too_long() {
    return {0, ErrorCode::kMalformed, fmt::format("line longer than {} characters", kLongestLine)};
}

}  // namespace gripscan::gsp
