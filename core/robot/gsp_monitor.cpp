#include "core/robot/gsp_monitor.h"

#include <fmt/format.h>

namespace gripscan::gsp {

RobotResult<RobotIdentity> GspMonitor::connect() {
    const std::lock_guard lock(mutex_);
    channel_.reset();
    if (auto opened = open(); !opened) return tl::unexpected<RobotError>(opened.error());
    wanted_ = true;
    return channel_->identity();
}

void GspMonitor::disconnect() {
    const std::lock_guard lock(mutex_);
    wanted_ = false;
    channel_.reset();
}

RobotResult<Position> GspMonitor::position(int attempts) {
    return ask<PositionReply>(AskPosition{}, attempts).map([](const PositionReply& reply) {
        return reply.position;
    });
}

RobotResult<StateReply> GspMonitor::state(int attempts) {
    return ask<StateReply>(AskState{}, attempts);
}

RobotResult<void> GspMonitor::stop(int attempts) {
    return ask<StopReply>(Stop{}, attempts).map([](const StopReply&) {});
}

template <typename Wanted>
RobotResult<Wanted> GspMonitor::ask(const Request& request, int attempts) {
    const std::lock_guard lock(mutex_);
    if (!wanted_) {
        return tl::unexpected<RobotError>(
            RobotError{RobotFault::kUnreachable, 0, 0, "the robot is not connected"});
    }
    for (int attempt = 1;; ++attempt) {
        auto reply = ask_once(request);
        if (reply) {
            if (auto* wanted = std::get_if<Wanted>(&*reply)) return *std::move(wanted);
            if (const auto* refusal = std::get_if<Failure>(&*reply)) {
                return tl::unexpected<RobotError>(robot_error(refusal->code, refusal->text));
            }
            channel_.reset();  // out of step: its next replies would be wrong too
            reply = tl::unexpected<RobotError>(
                RobotError{RobotFault::kProtocol, 0, 0,
                           fmt::format("the controller answers {} with '{}'", encode(request),
                                       encode(*reply))});
        }
        if (attempt >= attempts) return tl::unexpected<RobotError>(reply.error());
    }
}

RobotResult<Reply> GspMonitor::ask_once(const Request& request) {
    if (!channel_) {
        if (auto opened = open(); !opened) return tl::unexpected<RobotError>(opened.error());
    }
    const Deadline deadline = deadline_in(settings_.reply_limit);
    const auto sent = channel_->send(request, deadline);
    auto reply = sent ? channel_->receive(deadline)
                      : RobotResult<Reply>(tl::unexpected<RobotError>(sent.error()));
    // A reply that comes later must not be taken for the next one's.
    if (!reply) channel_.reset();
    return reply;
}

RobotResult<void> GspMonitor::open() {
    auto opened = GspChannel::open(settings_, settings_.port_of_monitor(), settings_.reply_limit);
    if (!opened) return tl::unexpected<RobotError>(opened.error());
    channel_ = *std::move(opened);
    return {};
}

}  // namespace gripscan::gsp
