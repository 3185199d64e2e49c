#include "core/robot/gsp_right_of_way.h"

namespace gripscan::gsp {

RightOfWay::Grant RightOfWay::to_ask() {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [&] { return !taken_ && stops_waiting_ == 0; });
    taken_ = true;
    cut_ = std::stop_source();
    return {*this, cut_.get_token()};
}

RightOfWay::Grant RightOfWay::to_stop(std::chrono::milliseconds patience) {
    const auto is_free = [&] { return !taken_; };
    std::unique_lock lock(mutex_);
    ++stops_waiting_;
    if (!changed_.wait_for(lock, patience, is_free)) {
        cut_.request_stop();
        changed_.wait(lock, is_free);
    }
    --stops_waiting_;
    taken_ = true;
    cut_ = std::stop_source(std::nostopstate);
    return {*this, cut_.get_token()};
}

void RightOfWay::leave() {
    {
        const std::lock_guard lock(mutex_);
        taken_ = false;
    }
    changed_.notify_all();
}

}  // namespace gripscan::gsp
