// Asks the monitor for the position again and again, and tells of each answer.
#pragma once

#include <condition_variable>
#include <functional>
#include <mutex>
#include <thread>

#include "core/robot/gsp_monitor.h"

namespace gripscan::gsp {

/// Runs from its construction to its destruction, which waits for the beat under way.
class GspHeartbeat {
  public:
    using Receiver = std::function<void(const RobotBeat&)>;

    GspHeartbeat(GspMonitor& monitor, const GspSettings& settings, Receiver receiver);

    /// Beats faster while something moves.
    void set_moving(bool moving);

  private:
    void run(const std::stop_token& stop);
    [[nodiscard]] RobotBeat beat();

    GspMonitor& monitor_;
    const GspSettings settings_;
    const Receiver receiver_;
    std::mutex mutex_;
    std::condition_variable_any changed_;
    bool moving_ = false;
    std::jthread thread_;  // last: it uses all of the above
};

}  // namespace gripscan::gsp
