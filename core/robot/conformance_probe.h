// The two bare connections of a conformance run, and what its checks remember.
#pragma once

#include <fmt/format.h>

#include <optional>
#include <string>
#include <variant>

#include "core/robot/line_channel.h"
#include "core/robot/robot_conformance.h"

namespace gripscan::gsp {

/// What came instead of a line.
struct NoLine {
    enum class Kind {
        kSilence,  ///< nothing within the limit
        kClosed,   ///< the connection is over
        kNonsense  ///< bytes, but no line
    };
    Kind kind = Kind::kSilence;
    std::string what;  ///< for people: "(no answer)", "(connection closed)" …
};

/// One connection to a port. What it says may be anything.
class ProbeLink {
  public:
    ProbeLink(const ConformanceSettings& settings, std::uint16_t port)
        : settings_(settings), port_(port) {}

    /// Connects anew, without a HELLO.
    [[nodiscard]] TcpResult<void> open();
    void close() { channel_.reset(); }
    [[nodiscard]] std::string peer() const { return place_of(settings_.host, port_); }

    /// Opens the connection first where it is closed, as ask() does.
    void send(std::string_view bytes);
    void send_line(std::string_view line);
    [[nodiscard]] tl::expected<std::string, NoLine> next(std::chrono::milliseconds limit);
    /// What has come of a line without its end.
    [[nodiscard]] std::string pending() const { return channel_ ? channel_->pending() : ""; }

    /// Sends a line; the reply to it, as text.
    [[nodiscard]] std::string ask(std::string_view line);
    /// The reply where it is one of GSP/1 and of this kind.
    template <typename Wanted>
    [[nodiscard]] std::optional<Wanted> ask_for(const Request& request) {
        auto reply = decode_reply(ask(encode(request)));
        if (!reply) return std::nullopt;
        auto* wanted = std::get_if<Wanted>(&*reply);
        return wanted ? std::optional<Wanted>(*std::move(wanted)) : std::nullopt;
    }

  private:
    const ConformanceSettings& settings_;
    std::uint16_t port_;
    std::optional<LineChannel> channel_;
};

struct Probe {
    explicit Probe(const ConformanceSettings& s)
        : settings(s), motion(s, s.motion_port), monitor(s, s.monitor_port) {}

    const ConformanceSettings& settings;
    ProbeLink motion;
    ProbeLink monitor;

    void close() {
        motion.close();
        monitor.close();
    }

    // With motion:
    std::optional<Position> start;   ///< before the first turn
    int last_id = 0;                 ///< the last that was used
    double direction = 1.0;          ///< of turns away from the start
    std::optional<TurnJoint6> turn;  ///< the last that was made
    std::string done_line;           ///< how it was answered
};

/// What a check found.
struct Verdict {
    CheckOutcome outcome = CheckOutcome::kFailed;
    std::string seen;
};

struct CheckRow {
    std::string_view name;
    std::string_view required;
    Verdict (*check)(Probe& probe);
};

[[nodiscard]] std::vector<CheckRow> still_checks();
[[nodiscard]] std::vector<CheckRow> moving_checks();

// Words for the checks.

[[nodiscard]] inline Verdict passed_if(bool holds, std::string seen) {
    return {holds ? CheckOutcome::kPassed : CheckOutcome::kFailed, std::move(seen)};
}
[[nodiscard]] inline Verdict skipped(std::string why) {
    return {CheckOutcome::kSkipped, std::move(why)};
}
/// For a command that no controller may take: if this reply says that it was taken, the arm is
/// stopped.
void stop_if_taken(Probe& probe, std::string_view line);
/// Is it "ERR <id> <code> …"? An id of 0 is right in any case where `zero_too`.
[[nodiscard]] bool is_error(std::string_view line, int id, ErrorCode code, bool zero_too = false);
template <typename Wanted>
[[nodiscard]] bool is_reply(std::string_view line) {
    const auto reply = decode_reply(line);
    return reply && std::holds_alternative<Wanted>(*reply);
}

}  // namespace gripscan::gsp
