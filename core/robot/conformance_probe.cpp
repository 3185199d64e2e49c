#include "core/robot/conformance_probe.h"

namespace gripscan::gsp {

TcpResult<void> ProbeLink::open() {
    channel_.reset();
    auto connection =
        TcpConnection::connect(settings_.host, port_, deadline_in(settings_.connect_limit));
    if (!connection) return tl::unexpected<TcpError>(connection.error());
    channel_.emplace(*std::move(connection));
    return {};
}

void ProbeLink::send(std::string_view bytes) {
    if (!channel_) (void)open();
    // A connection that went is noticed by what does not come back.
    if (channel_) {
        (void)channel_->connection().write(bytes, deadline_in(settings_.reply_limit));
    }
}

void ProbeLink::send_line(std::string_view line) {
    send(std::string(line).append(kLineEnd));
}

tl::expected<std::string, NoLine> ProbeLink::next(std::chrono::milliseconds limit) {
    using enum NoLine::Kind;
    const auto none = [](NoLine::Kind kind, std::string what) {
        return tl::unexpected<NoLine>(NoLine{kind, std::move(what)});
    };
    if (!channel_) return none(kClosed, "(not connected)");
    const auto item = channel_->read(deadline_in(limit));
    if (!item && item.error().fault == TcpFault::kTimeout) return none(kSilence, "(no answer)");
    if (!item) return none(kClosed, "(connection closed)");
    if (const auto* line = std::get_if<Line>(&*item)) return line->text;
    if (const auto* line = std::get_if<OverlongLine>(&*item)) {
        return none(kNonsense, fmt::format("(a line of {} characters)", line->length));
    }
    return none(kNonsense, fmt::format("({})", std::get<BrokenStream>(*item).why));
}

std::string ProbeLink::ask(std::string_view line) {
    if (!channel_) {
        if (const auto opened = open(); !opened) return fmt::format("({})", opened.error().message);
    }
    send_line(line);
    auto reply = next(settings_.reply_limit);
    if (reply) return *std::move(reply);
    channel_.reset();  // what comes later must not be taken for the next reply
    return reply.error().what;
}

void stop_if_taken(Probe& probe, std::string_view line) {
    if (is_reply<Accepted>(line)) (void)probe.monitor.ask(encode(Request(Stop{})));
}

bool is_error(std::string_view line, int id, ErrorCode code, bool zero_too) {
    const auto reply = decode_reply(line);
    const auto* failure = reply ? std::get_if<Failure>(&*reply) : nullptr;
    return failure && failure->code == code &&
           (failure->id == id || (zero_too && failure->id == 0));
}

}  // namespace gripscan::gsp
