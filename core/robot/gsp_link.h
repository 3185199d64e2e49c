// A controller that speaks GSP/1, over TCP.
#pragma once

#include <memory>
#include <optional>

#include "core/robot/gsp_heartbeat.h"
#include "core/robot/gsp_settings.h"
#include "core/robot/robot_link.h"

namespace gripscan::gsp {

/// read(), state() and stop() use the monitor connection, turns the motion connection and both.
///
/// A turn that ends with motion_unknown() has no outcome yet: until it has one, only the same turn
/// may be asked again (any other is kRefused), or connect() is called, which finds that the arm
/// stands still. A controller whose motion port is taken by another client can be watched and
/// stopped with `motion_rights` off.
class GspLink : public RobotLink {
  public:
    explicit GspLink(GspSettings settings);
    ~GspLink() override;

    [[nodiscard]] RobotResult<RobotIdentity> connect() override;
    void disconnect() override;

    [[nodiscard]] RobotResult<ControllerState> state() override;
    [[nodiscard]] RobotResult<RobotReading> read() override;
    [[nodiscard]] RobotResult<RobotReading> turn_joint6(const Joint6Command& command,
                                                        std::stop_token stop) override;
    [[nodiscard]] RobotResult<void> stop() override;

    /// The receiver must not call connect() or disconnect().
    void on_beat(std::function<void(const RobotBeat&)> receiver) override;

    [[nodiscard]] const GspSettings& settings() const { return settings_; }

  private:
    /// What is known before a turn: where the arm is, and how fast it will be.
    struct Start {
        RobotReading reading;
        std::chrono::milliseconds motion_time{};
    };
    RobotResult<void> check_permission(const TurnJoint6& turn) const;
    RobotResult<Start> prepare(const TurnJoint6& turn);
    RobotResult<Position> move(const TurnJoint6& turn, std::chrono::milliseconds motion_time,
                               const std::stop_token& stop);

    const GspSettings settings_;
    GspMonitor monitor_;
    std::optional<GspChannel> motion_;
    std::optional<TurnJoint6> unresolved_;
    std::function<void(const RobotBeat&)> receiver_;
    std::unique_ptr<GspHeartbeat> heartbeat_;  // last: it uses the monitor
};

}  // namespace gripscan::gsp
