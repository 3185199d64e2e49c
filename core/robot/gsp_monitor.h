// The monitor connection: questions that change nothing, and STOP. Shared by all threads of a link.
#pragma once

#include <optional>

#include "core/robot/gsp_channel.h"
#include "core/robot/gsp_right_of_way.h"

namespace gripscan::gsp {

/// Every call ends within a reply limit, or with connecting anew in between. Safe to be called from
/// any thread; they take turns, and STOP goes first.
class GspMonitor {
  public:
    /// For how long STOP waits for a question under way, and then for its own reply on a connection
    /// that may be half-open, before it is said on a new one. A controller answers in 10 … 40 ms.
    static constexpr std::chrono::milliseconds kStopPatience{300};

    explicit GspMonitor(const GspSettings& settings) : settings_(settings) {}

    [[nodiscard]] RobotResult<RobotIdentity> connect();
    /// From now on every question is answered with kUnreachable.
    void disconnect();

    /// A lost connection is opened again for the question; these questions can be repeated.
    [[nodiscard]] RobotResult<Position> position(int attempts = 2);
    [[nodiscard]] RobotResult<StateReply> state(int attempts = 2);
    /// Is out within twice the patience and the time that connecting takes.
    [[nodiscard]] RobotResult<void> stop(int attempts = 2);

  private:
    template <typename Wanted>
    RobotResult<Wanted> ask(const Request& request, int attempts);
    RobotResult<Reply> ask_once(const Request& request, const std::stop_token& cut);
    RobotResult<Reply> stop_once();
    RobotResult<Reply> exchange(const Request& request, std::chrono::milliseconds limit,
                                const std::stop_token& cut);
    RobotResult<void> open(const std::stop_token& cut);
    template <typename Wanted>
    RobotResult<Wanted> wanted_in(RobotResult<Reply> reply, const Request& request);

    const GspSettings settings_;
    RightOfWay right_of_way_;
    // Of whoever has the right of way:
    bool wanted_ = false;
    std::optional<GspChannel> channel_;
};

}  // namespace gripscan::gsp
