#include "core/sim/disturbed_channel.h"

#include <condition_variable>
#include <mutex>

namespace gripscan::sim {
namespace {

constexpr std::chrono::seconds kWrite{2};

/// Sleeps, but no longer than until a stop is requested.
void sleep(double time_s, const std::stop_token& stop) {
    std::mutex mutex;
    std::unique_lock lock(mutex);
    std::condition_variable_any never;
    never.wait_for(lock, stop, std::chrono::duration<double>(time_s), [] { return false; });
}

/// Every letter is the next one of the alphabet: a line, but of no known word.
std::string garbled(std::string_view line) {
    std::string text(line);
    for (char& c : text) {
        if (c > ' ' && c < '~') ++c;
    }
    return text;
}

}  // namespace

bool DisturbedChannel::send(const Exchange& exchange, const std::stop_token& stop) {
    if (mute_) return true;
    const bool sent = exchange.disturbed ? send_disturbed(exchange.line, *exchange.disturbed, stop)
                                         : say(exchange.line);
    if (!sent || !exchange.afterwards) return sent;
    return send_disturbed("", *exchange.afterwards, stop);
}

bool DisturbedChannel::send_disturbed(std::string_view line, const Fault& fault,
                                      const std::stop_token& stop) {
    switch (fault.kind) {
        case FaultKind::kDelay:
            sleep(fault.amount, stop);
            return say(line);
        case FaultKind::kGarble:
            return say(garbled(line.empty() ? "NOISE 7" : line));
        case FaultKind::kSplit:
            return send_split(line, fault.amount, stop);
        case FaultKind::kHalfOpen:
            mute_ = true;
            return true;
        default:
            channel_.close();
            return false;
    }
}

bool DisturbedChannel::send_split(std::string_view line, double pause_s,
                                  const std::stop_token& stop) {
    if (line.empty()) return true;
    std::string bytes(line);
    bytes += kLineEnd;
    for (const char byte : bytes) {
        const auto sent = channel_.connection().write({&byte, 1}, deadline_in(kWrite));
        if (!sent) return false;
        sleep(pause_s, stop);
    }
    return true;
}

bool DisturbedChannel::say(std::string_view line) {
    if (line.empty()) return true;
    const auto sent = channel_.write(line, deadline_in(kWrite));
    return sent.has_value();
}

}  // namespace gripscan::sim
