#include "core/robot/gsp_monitor.h"

#include <fmt/format.h>

#include <algorithm>

namespace gripscan::gsp {
namespace {

tl::unexpected<RobotError> failed(RobotFault fault, std::string message) {
    return tl::unexpected<RobotError>(RobotError{fault, 0, 0, std::move(message)});
}

tl::unexpected<RobotError> not_connected() {
    return failed(RobotFault::kUnreachable, "the robot is not connected");
}

/// A reply, or a refusal of the controller: asking again would not change it.
template <typename Wanted>
bool is_answer(const RobotResult<Wanted>& reply) {
    return reply || reply.error().code != 0;
}

}  // namespace

RobotResult<RobotIdentity> GspMonitor::connect() {
    const auto grant = right_of_way_.to_ask();
    channel_.reset();
    if (auto opened = open(grant.cut()); !opened) {
        return tl::unexpected<RobotError>(opened.error());
    }
    wanted_ = true;
    return channel_->identity();
}

void GspMonitor::disconnect() {
    const auto grant = right_of_way_.to_ask();
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
    for (int attempt = 1;; ++attempt) {
        const auto grant = right_of_way_.to_stop(kStopPatience);
        if (!wanted_) return not_connected();
        const auto reply = wanted_in<StopReply>(stop_once(), Stop{});
        if (is_answer(reply) || attempt >= attempts) return reply.map([](const StopReply&) {});
    }
}

template <typename Wanted>
RobotResult<Wanted> GspMonitor::ask(const Request& request, int attempts) {
    for (int attempt = 1;; ++attempt) {
        const auto grant = right_of_way_.to_ask();
        if (!wanted_) return not_connected();
        auto reply = wanted_in<Wanted>(ask_once(request, grant.cut()), request);
        if (is_answer(reply) || attempt >= attempts) return reply;
    }
}

template <typename Wanted>
RobotResult<Wanted> GspMonitor::wanted_in(RobotResult<Reply> reply, const Request& request) {
    if (!reply) return tl::unexpected<RobotError>(reply.error());
    if (auto* wanted = std::get_if<Wanted>(&*reply)) return *std::move(wanted);
    if (const auto* refusal = std::get_if<Failure>(&*reply)) {
        return tl::unexpected<RobotError>(robot_error(refusal->code, refusal->text));
    }
    channel_.reset();  // out of step: its next replies would be wrong too
    return failed(RobotFault::kProtocol, fmt::format("the controller answers {} with '{}'",
                                                     encode(request), encode(*reply)));
}

RobotResult<Reply> GspMonitor::ask_once(const Request& request, const std::stop_token& cut) {
    const auto opened = channel_ ? RobotResult<void>() : open(cut);
    auto reply = opened ? exchange(request, settings_.reply_limit, cut)
                        : RobotResult<Reply>(tl::unexpected<RobotError>(opened.error()));
    if (reply || !cut.stop_requested()) return reply;
    return failed(RobotFault::kLost, "a question to the controller made way for STOP");
}

/// On a connection that is there, and if no answer comes, on a new one, before its HELLO.
RobotResult<Reply> GspMonitor::stop_once() {
    if (channel_) {
        auto reply = exchange(Stop{}, std::min(kStopPatience, settings_.reply_limit), {});
        if (reply) return reply;
    }
    auto connected = GspChannel::connect(settings_, settings_.port_of_monitor());
    if (!connected) return tl::unexpected<RobotError>(connected.error());
    channel_ = *std::move(connected);
    auto reply = exchange(Stop{}, settings_.reply_limit, {});
    if (reply && !channel_->greet(settings_, settings_.reply_limit)) channel_.reset();
    return reply;
}

RobotResult<Reply> GspMonitor::exchange(const Request& request, std::chrono::milliseconds limit,
                                        const std::stop_token& cut) {
    auto reply = [&]() -> RobotResult<Reply> {
        const std::stop_callback on_cut(cut, [&] { channel_->close(); });
        const Deadline deadline = deadline_in(limit);
        if (auto sent = channel_->send(request, deadline); !sent) {
            return tl::unexpected<RobotError>(sent.error());
        }
        return channel_->receive(deadline);
    }();
    // A reply that comes later must not be taken for the next one's.
    if (!reply) channel_.reset();
    return reply;
}

RobotResult<void> GspMonitor::open(const std::stop_token& cut) {
    auto opened =
        GspChannel::open(settings_, settings_.port_of_monitor(), settings_.reply_limit, cut);
    if (!opened) return tl::unexpected<RobotError>(opened.error());
    channel_ = *std::move(opened);
    return {};
}

}  // namespace gripscan::gsp
