// Does a controller, real or simulated, keep to GSP/1? One result a check: what is required, and
// what was seen. It speaks to the bare sockets, so that it can say what no client should.
#pragma once

#include <chrono>
#include <functional>
#include <stop_token>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/robot/gsp_message.h"

namespace gripscan::gsp {

struct ConformanceSettings {
    std::string host = "127.0.0.1";
    std::uint16_t motion_port = kMotionPort;
    std::uint16_t monitor_port = kMotionPort + 1;
    bool move = false;           ///< joint 6 may be turned, at least 1.5 `step_deg` to one side
    double step_deg = 10.0;      ///< of joint 6; it takes more than a second at `speed_percent`
    double speed_percent = 1.0;  ///< the slowest that every controller has to take
    std::chrono::milliseconds connect_limit{3000};
    std::chrono::milliseconds reply_limit{2000};
    std::chrono::milliseconds motion_limit{20000};
    std::chrono::milliseconds split_pause{100};  ///< between the parts of a line
};

enum class CheckOutcome {
    kPassed,
    kFailed,
    kSkipped,  ///< could not be tried; `seen` says why
    kNoted,    ///< nothing is required: for information
};

[[nodiscard]] std::string_view name_of(CheckOutcome outcome);

struct ConformanceCheck {
    std::string name;
    CheckOutcome outcome = CheckOutcome::kFailed;
    std::string seen;
    std::string required;
};

struct ConformanceReport {
    std::vector<ConformanceCheck> checks;
    /// Nothing failed.
    [[nodiscard]] bool conforms() const;
};

/// Told of each check when it is done.
using CheckReceiver = std::function<void(const ConformanceCheck&)>;

/// An error if one of the ports cannot be reached or is held by another client, or if it was
/// stopped; then nothing moves any more. With `move`, joint 6 is brought back to where it was.
[[nodiscard]] Result<ConformanceReport> check_conformance(const ConformanceSettings& settings,
                                                          const CheckReceiver& receiver,
                                                          const std::stop_token& stop);

}  // namespace gripscan::gsp
