// Who may use the monitor connection: one at a time, and STOP before everybody else.
#pragma once

#include <chrono>
#include <condition_variable>
#include <mutex>
#include <stop_token>

namespace gripscan::gsp {

/// From any thread.
class RightOfWay {
  public:
    /// While it lives nobody else has the right.
    class Grant {
      public:
        Grant(RightOfWay& owner, std::stop_token cut) : owner_(owner), cut_(std::move(cut)) {}
        ~Grant() { owner_.leave(); }
        Grant(const Grant&) = delete;
        Grant& operator=(const Grant&) = delete;

        /// A STOP waits for longer than it may: end the exchange at once.
        [[nodiscard]] const std::stop_token& cut() const { return cut_; }

      private:
        RightOfWay& owner_;
        const std::stop_token cut_;
    };

    /// Waits for whoever has it, and for every STOP.
    [[nodiscard]] Grant to_ask();
    /// Waits for a question for no longer than that, then cuts it. A STOP is not cut by another.
    [[nodiscard]] Grant to_stop(std::chrono::milliseconds patience);

  private:
    void leave();

    std::mutex mutex_;
    std::condition_variable changed_;
    bool taken_ = false;
    int stops_waiting_ = 0;
    std::stop_source cut_;  ///< of whoever has it
};

}  // namespace gripscan::gsp
