#include "core/robot/gsp_stop_relay.h"

namespace gripscan::gsp {

StopRelay::StopRelay(GspMonitor& monitor, std::chrono::milliseconds pause, std::stop_token request)
    : monitor_(monitor),
      pause_(pause),
      thread_([this, request = std::move(request)](const std::stop_token& end) {
          run(end, request);
      }) {}

void StopRelay::run(const std::stop_token& end, const std::stop_token& request) {
    {
        const std::stop_callback on_request(request, [this] {
            const std::lock_guard lock(mutex_);
            wake_.notify_all();
        });
        std::unique_lock lock(mutex_);
        wake_.wait(lock, end, [&] { return request.stop_requested(); });
    }
    while (!end.stop_requested()) {
        (void)monitor_.stop();  // what cannot be said now is said again
        std::unique_lock lock(mutex_);
        wake_.wait_for(lock, end, pause_, [] { return false; });
    }
}

}  // namespace gripscan::gsp
