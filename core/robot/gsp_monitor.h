// The monitor connection: questions that change nothing, and STOP. Shared by all threads of a link.
#pragma once

#include <mutex>
#include <optional>

#include "core/robot/gsp_channel.h"

namespace gripscan::gsp {

/// Every call ends within a reply limit, or with connecting anew in between. Safe to be called from
/// any thread; they take turns.
class GspMonitor {
  public:
    explicit GspMonitor(const GspSettings& settings) : settings_(settings) {}

    [[nodiscard]] RobotResult<RobotIdentity> connect();
    /// From now on every question is answered with kUnreachable.
    void disconnect();

    /// A lost connection is opened again for the question; these questions can be repeated.
    [[nodiscard]] RobotResult<Position> position(int attempts = 2);
    [[nodiscard]] RobotResult<StateReply> state(int attempts = 2);
    [[nodiscard]] RobotResult<void> stop(int attempts = 2);

  private:
    template <typename Wanted>
    RobotResult<Wanted> ask(const Request& request, int attempts);
    RobotResult<Reply> ask_once(const Request& request);
    RobotResult<void> open();

    const GspSettings settings_;
    std::mutex mutex_;
    bool wanted_ = false;
    std::optional<GspChannel> channel_;
};

}  // namespace gripscan::gsp
