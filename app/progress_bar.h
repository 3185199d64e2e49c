// A progress bar on standard error, only where that is a terminal.
#pragma once

#include <chrono>
#include <mutex>
#include <string>

#include "app/context.h"
#include "core/base/progress.h"

namespace gripscan::app {

class ProgressBar {
  public:
    explicit ProgressBar(const Context& context);
    ~ProgressBar();
    ProgressBar(const ProgressBar&) = delete;
    ProgressBar& operator=(const ProgressBar&) = delete;

    /// Valid as long as the bar lives.
    [[nodiscard]] Progress progress();

  private:
    using Clock = std::chrono::steady_clock;
    void show(std::string_view stage, std::size_t done, std::size_t total);
    void end_line();

    std::stop_token stop_;
    bool visible_ = false;
    std::mutex mutex_;
    std::string stage_;
    std::size_t done_ = 0;
    Clock::time_point began_;
    Clock::time_point drawn_;
};

}  // namespace gripscan::app
