// Joint 6 of an arm that turns evenly, and keeps account of what it was made to do.
#pragma once

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <mutex>

namespace gripscan::test {

/// Angles in deg. From any thread.
class MockArm {
  public:
    using Clock = std::chrono::steady_clock;

    void start(double target_deg, std::chrono::milliseconds duration) {
        const std::lock_guard lock(mutex_);
        settle();
        begin_deg_ = joints_deg_[5];
        target_deg_ = target_deg;
        begin_ = Clock::now();
        duration_ = duration;
        moving_ = true;
        if (target_deg != begin_deg_) ++moves_;
    }
    /// Where it is; as a controller's restart and its STOP do.
    void halt() {
        const std::lock_guard lock(mutex_);
        settle();
        moving_ = false;
    }
    [[nodiscard]] bool moving() {
        const std::lock_guard lock(mutex_);
        settle();
        return moving_;
    }
    [[nodiscard]] std::array<double, 6> joints_deg() {
        const std::lock_guard lock(mutex_);
        settle();
        return joints_deg_;
    }
    void shift_joint(std::size_t index, double by_deg) {
        const std::lock_guard lock(mutex_);
        settle();
        joints_deg_.at(index) += by_deg;
    }
    /// How often it was sent somewhere else than where it stood.
    [[nodiscard]] int moves() const {
        const std::lock_guard lock(mutex_);
        return moves_;
    }
    /// All that joint 6 was turned, there and back counted twice.
    [[nodiscard]] double travelled_deg() {
        const std::lock_guard lock(mutex_);
        settle();
        return travelled_deg_;
    }

  private:
    void settle() {
        if (!moving_) return;
        const double share = std::chrono::duration<double>(Clock::now() - begin_) / duration_;
        const double now_deg =
            share >= 1.0 ? target_deg_ : begin_deg_ + share * (target_deg_ - begin_deg_);
        travelled_deg_ += std::abs(now_deg - joints_deg_[5]);
        joints_deg_[5] = now_deg;
        moving_ = share < 1.0;
    }

    mutable std::mutex mutex_;
    std::array<double, 6> joints_deg_{0, 0, 0, 0, -90, 0};
    double begin_deg_ = 0.0;
    double target_deg_ = 0.0;
    Clock::time_point begin_;
    std::chrono::duration<double> duration_{};
    bool moving_ = false;
    int moves_ = 0;
    double travelled_deg_ = 0.0;
};

}  // namespace gripscan::test
