#include "core/robot/gsp_link.h"

#include <fmt/format.h>

#include <cmath>

#include "core/base/units.h"
#include "core/robot/command_ids.h"
#include "core/robot/gsp_reading.h"
#include "core/robot/gsp_stop_relay.h"
#include "core/robot/gsp_turn.h"

namespace gripscan::gsp {
namespace {

tl::unexpected<RobotError> failed(RobotFault fault, std::string message) {
    return tl::unexpected<RobotError>(RobotError{fault, 0, 0, std::move(message)});
}

/// As it reads on the wire, so that asking again is asking the same.
TurnJoint6 on_the_wire(const Joint6Command& command) {
    constexpr double kUnitsPerDeg = 1e4;
    const auto rounded = [](double value) {
        return std::round(value * kUnitsPerDeg) / kUnitsPerDeg;
    };
    return {command.id, rounded(deg_from_rad(command.angle_rad)), rounded(command.speed_percent)};
}

}  // namespace

GspLink::GspLink(GspSettings settings) : settings_(std::move(settings)), monitor_(settings_) {}

GspLink::~GspLink() {
    disconnect();
}

RobotResult<RobotIdentity> GspLink::connect() {
    disconnect();
    if (settings_.motion_rights) {
        auto opened = GspChannel::open(settings_, settings_.motion_port, settings_.reply_limit);
        if (!opened) return tl::unexpected<RobotError>(opened.error());
        motion_ = *std::move(opened);
    }
    auto identity = monitor_.connect();
    if (!identity) {
        motion_.reset();
        return identity;
    }
    // The motion task answered HELLO, so it waits for commands: if nothing moves either, the turn
    // that was lost has come to its end.
    if (motion_ && unresolved_) {
        const auto state = monitor_.state();
        if (state && state->moving == false) unresolved_.reset();
    }
    heartbeat_ = std::make_unique<GspHeartbeat>(monitor_, settings_, receiver_);
    return identity;
}

void GspLink::disconnect() {
    heartbeat_.reset();
    monitor_.disconnect();
    motion_.reset();
}

RobotResult<ControllerState> GspLink::state() {
    return monitor_.state().map(state_from);
}

RobotResult<RobotReading> GspLink::read() {
    return monitor_.position().and_then(reading_from);
}

RobotResult<void> GspLink::stop() {
    return monitor_.stop();
}

void GspLink::on_beat(std::function<void(const RobotBeat&)> receiver) {
    receiver_ = std::move(receiver);
}

RobotResult<void> GspLink::check_permission(const TurnJoint6& turn) const {
    if (!settings_.motion_rights) {
        return failed(RobotFault::kRefused, "this link has no right to move the robot");
    }
    if (!heartbeat_) return failed(RobotFault::kUnreachable, "the robot is not connected");
    if (turn.id < 1 || turn.id > kGreatestId) {
        return failed(RobotFault::kOutOfRange,
                      fmt::format("{} is no id of a turn; ids are 1 … {}", turn.id, kGreatestId));
    }
    if (unresolved_ && *unresolved_ != turn) {
        return failed(RobotFault::kRefused,
                      fmt::format("turn {} has no outcome yet: ask for the same again, or connect "
                                  "anew, before turn {}",
                                  unresolved_->id, turn.id));
    }
    return {};
}

RobotResult<GspLink::Start> GspLink::prepare(const TurnJoint6& turn) {
    const auto state = monitor_.state();
    if (!state) return tl::unexpected<RobotError>(state.error());
    const auto before = read();
    if (!before) return tl::unexpected<RobotError>(before.error());
    if (auto allowed = check_turn(turn, before->joints_rad, settings_); !allowed) {
        return tl::unexpected<RobotError>(allowed.error());
    }
    const double turn_deg = turn.angle_deg - deg_from_rad(before->joints_rad[5]);
    return Start{*before,
                 motion_time(turn_deg, turn.speed_percent, state->override_percent, settings_)};
}

RobotResult<Position> GspLink::move(const TurnJoint6& turn, std::chrono::milliseconds motion_time,
                                    const std::stop_token& stop) {
    const StopRelay relay(monitor_, settings_.retry_pause, stop);
    heartbeat_->set_moving(true);
    auto position = make_turn({settings_, motion_, monitor_}, turn, motion_time, stop);
    heartbeat_->set_moving(false);
    return position;
}

RobotResult<RobotReading> GspLink::turn_joint6(const Joint6Command& command, std::stop_token stop) {
    const TurnJoint6 turn = on_the_wire(command);
    if (auto permitted = check_permission(turn); !permitted) {
        return tl::unexpected<RobotError>(permitted.error());
    }
    const bool asked_before = unresolved_.has_value();
    if (stop.stop_requested()) {
        if (!asked_before) return failed(RobotFault::kStopped, "stopped before anything moved");
        (void)monitor_.stop();  // the caller is told in any case that the outcome is unknown
        return failed(RobotFault::kLost,
                      fmt::format("turn {} was to be stopped, and is not asked for again; whether "
                                  "it was made is unknown",
                                  turn.id));
    }
    // Until the command is sent, trouble of the link leaves the arm where it is.
    const auto as_before = [&](RobotError error) {
        if (error.motion_unknown() || error.fault == RobotFault::kUnreachable) {
            error.fault = asked_before ? RobotFault::kLost : RobotFault::kUnreachable;
        }
        return tl::unexpected<RobotError>(std::move(error));
    };
    const auto start = prepare(turn);
    if (!start) return as_before(start.error());
    unresolved_ = turn;
    const auto position = move(turn, start->motion_time, stop);
    if (!position) {
        if (position.error().motion_unknown()) return tl::unexpected<RobotError>(position.error());
        if (position.error().fault != RobotFault::kUnreachable || !asked_before)
            unresolved_.reset();
        return as_before(position.error());
    }
    unresolved_.reset();
    const auto after = reading_from(*position);
    if (!after) return after;
    if (auto arrived = check_arrival(turn, start->reading.joints_rad, after->joints_rad, settings_);
        !arrived) {
        return tl::unexpected<RobotError>(arrived.error());
    }
    return after;
}

}  // namespace gripscan::gsp
