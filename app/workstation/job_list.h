// Long work beside the window: each job on a thread of its own, one at a time of every name, with
// progress and cancel. Its outcome is taken in on the window's thread.
#pragma once

#include <atomic>
#include <chrono>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "core/base/progress.h"

namespace gripscan::app {

class JobList {
  public:
    /// What the window does with the outcome; runs in pump().
    using Outcome = std::function<void()>;
    using Work = std::function<Outcome(const Progress&)>;

    /// `wake` is called from the jobs' threads when there is something to show.
    explicit JobList(std::function<void()> wake) : wake_(std::move(wake)) {}
    /// Cancels and waits.
    ~JobList() = default;
    JobList(const JobList&) = delete;
    JobList& operator=(const JobList&) = delete;

    /// A job of the same name that is running is cancelled and its outcome never taken.
    void start(const std::string& name, Work work);
    /// Runs the outcomes that have come. On the window's thread.
    void pump();
    void cancel_all();
    /// Ends those of that name and waits for them; their outcome is not taken.
    void stop(const std::string& name);
    [[nodiscard]] bool running(const std::string& name) const;

    struct Shown {
        std::string name;
        double part = -1.0;  ///< 0 … 1; −1: unknown
        double elapsed_s = 0.0;
        bool stopping = false;  ///< it was cancelled and has not ended yet
    };
    /// The oldest that is running; nothing: none.
    [[nodiscard]] std::optional<Shown> shown() const;

  private:
    struct Job {
        std::string name;
        std::chrono::steady_clock::time_point begun = std::chrono::steady_clock::now();
        std::atomic<double> part = -1.0;
        std::mutex mutex;
        Outcome outcome;
        std::atomic<bool> done = false;
        bool unwanted = false;
        std::jthread thread;  // last: it uses all of the above
    };
    std::function<void()> wake_;
    std::vector<std::unique_ptr<Job>> jobs_;
};

}  // namespace gripscan::app
