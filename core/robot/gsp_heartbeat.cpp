#include "core/robot/gsp_heartbeat.h"

#include "core/robot/gsp_reading.h"

namespace gripscan::gsp {

GspHeartbeat::GspHeartbeat(GspMonitor& monitor, const GspSettings& settings, Receiver receiver)
    : monitor_(monitor),
      settings_(settings),
      receiver_(std::move(receiver)),
      thread_([this](const std::stop_token& stop) { run(stop); }) {}

void GspHeartbeat::set_moving(bool moving) {
    {
        const std::lock_guard lock(mutex_);
        moving_ = moving;
    }
    changed_.notify_all();
}

void GspHeartbeat::run(const std::stop_token& stop) {
    while (!stop.stop_requested()) {
        const RobotBeat now = beat();
        if (receiver_) receiver_(now);
        std::unique_lock lock(mutex_);
        const bool was_moving = moving_;
        changed_.wait_for(lock, stop,
                          moving_ ? settings_.beat_period_moving : settings_.beat_period,
                          [&] { return moving_ != was_moving; });
    }
}

RobotBeat GspHeartbeat::beat() {
    using Clock = std::chrono::steady_clock;
    const auto start = Clock::now();
    const auto reading = monitor_.position(1).and_then(reading_from);
    RobotBeat now;
    now.alive = reading.has_value();
    now.round_trip_s = std::chrono::duration<double>(Clock::now() - start).count();
    if (reading) {
        now.reading = *reading;
    } else {
        now.trouble = reading.error().message;
    }
    return now;
}

}  // namespace gripscan::gsp
