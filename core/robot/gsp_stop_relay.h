// Turns a stop request of the program into STOP on the monitor connection.
#pragma once

#include <condition_variable>
#include <mutex>
#include <stop_token>
#include <thread>

#include "core/robot/gsp_monitor.h"

namespace gripscan::gsp {

/// While it lives. STOP is said again and again until then: a command that was under way when the
/// first one was obeyed must not move the arm after it.
class StopRelay {
  public:
    StopRelay(GspMonitor& monitor, std::chrono::milliseconds pause, std::stop_token request);

  private:
    void run(const std::stop_token& end, const std::stop_token& request);

    GspMonitor& monitor_;
    const std::chrono::milliseconds pause_;
    std::mutex mutex_;
    std::condition_variable_any wake_;
    std::jthread thread_;  // last: it uses all of the above
};

}  // namespace gripscan::gsp
