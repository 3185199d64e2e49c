#include "core/robot/robot_conformance.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/robot/conformance_turns.h"

namespace gripscan::gsp {
namespace {

/// What a controller sends may be anything; what is told of it is one line.
std::string one_line(std::string text) {
    std::replace_if(
        text.begin(), text.end(), [](char c) { return (c >= 0 && c < ' ') || c == 0x7F; }, '?');
    return text;
}

/// Without these nothing that moves may be tried.
bool must_pass(std::string_view name) {
    return name == "move.ready" || name == "move.ids";
}

/// What has come instead of a reply of GSP/1, as one line; empty: nothing, or a reply.
std::string other_greeting(const ProbeLink& link, const tl::expected<std::string, NoLine>& line) {
    if (line) return decode_reply(*line) ? "" : fmt::format("'{}'", one_line(*line));
    if (line.error().kind == NoLine::Kind::kNonsense) return line.error().what;
    const std::string part = link.pending();
    return part.empty() ? "" : fmt::format("'{}' and no end of a line", one_line(part));
}

/// Is it the server of a controller, and free? It has room for one client: it takes the connection
/// of another, and does not answer.
Status check_free(ProbeLink& link, std::string_view name, std::chrono::milliseconds limit) {
    if (const auto opened = link.open(); !opened) {
        return device_error("{}; is the server on the controller started?", opened.error().message);
    }
    link.send_line(encode(Request(Hello{})));
    const auto line = link.next(limit);
    if (const std::string other = other_greeting(link, line); !other.empty()) {
        return device_error(
            "{} ({}) is no server of {}: to HELLO it answers {}; give the port that the "
            "controller's server listens at",
            link.peer(), name, kVersionText, other);
    }
    std::string seen = "refuses to talk: " + line.value_or("");
    if (!line) {
        seen = line.error().kind == NoLine::Kind::kSilence
                   ? fmt::format("does not answer HELLO within {} ms", limit.count())
                   : "closes it";
    } else if (!is_error(*line, 0, ErrorCode::kBusy)) {
        return {};
    }
    return device_error(
        "{} ({}) takes the connection, but {}; it has room for one client, and none "
        "while the arm moves: end the other client, then check again",
        link.peer(), name, one_line(std::move(seen)));
}

class Run {
  public:
    Run(const ConformanceSettings& settings, const CheckReceiver& receiver,
        const std::stop_token& stop)
        : probe_(settings), receiver_(receiver), stop_(stop) {}

    Result<ConformanceReport> all();

  private:
    void add(const CheckRow& row, const Verdict& verdict) {
        report_.checks.push_back({std::string(row.name), verdict.outcome, one_line(verdict.seen),
                                  std::string(row.required)});
        if (receiver_) receiver_(report_.checks.back());
        // What a check that failed has left on the way is not for the next one.
        if (verdict.outcome == CheckOutcome::kFailed) probe_.close();
    }
    /// Why no check that moves may be made; empty: they may.
    [[nodiscard]] std::string hindrance() const {
        if (!probe_.settings.move) return "no motion without --move";
        return not_ready_ ? "the controller is not ready to move" : "";
    }

    Probe probe_;
    const CheckReceiver& receiver_;
    const std::stop_token& stop_;
    bool not_ready_ = false;
    ConformanceReport report_;
};

Result<ConformanceReport> Run::all() {
    const auto limit = probe_.settings.reply_limit;
    if (auto s = check_free(probe_.motion, "motion", limit); !s) return forward_error(s.error());
    if (auto s = check_free(probe_.monitor, "monitor", limit); !s) return forward_error(s.error());
    for (const CheckRow& row : still_checks()) {
        if (stop_.stop_requested()) return cancelled_error();
        add(row, row.check(probe_));
    }
    for (const CheckRow& row : moving_checks()) {
        if (stop_.stop_requested()) {
            (void)probe_.monitor.ask("STOP");
            return cancelled_error();
        }
        const std::string why_not = hindrance();
        const Verdict verdict = why_not.empty() ? row.check(probe_) : skipped(why_not);
        add(row, verdict);
        if (verdict.outcome != CheckOutcome::kFailed) continue;
        if (must_pass(row.name)) not_ready_ = true;
        wait_until_it_stands(probe_);
    }
    return std::move(report_);
}

}  // namespace

std::string_view name_of(CheckOutcome outcome) {
    switch (outcome) {
        case CheckOutcome::kPassed:
            return "passed";
        case CheckOutcome::kFailed:
            return "failed";
        case CheckOutcome::kSkipped:
            return "skipped";
        case CheckOutcome::kNoted:
            return "noted";
    }
    return "failed";
}

bool ConformanceReport::conforms() const {
    return std::none_of(checks.begin(), checks.end(), [](const ConformanceCheck& check) {
        return check.outcome == CheckOutcome::kFailed;
    });
}

Result<ConformanceReport> check_conformance(const ConformanceSettings& settings,
                                            const CheckReceiver& receiver,
                                            const std::stop_token& stop) {
    return Run(settings, receiver, stop).all();
}

}  // namespace gripscan::gsp
