// One turn of joint 6 over the sockets: the state machine of gsp_exchange.h with clocks and links.
#pragma once

#include <optional>
#include <stop_token>

#include "core/robot/gsp_monitor.h"

namespace gripscan::gsp {

/// How long the turn may take, without margin.
[[nodiscard]] std::chrono::milliseconds motion_time(double turn_deg, double speed_percent,
                                                    std::optional<int> override_percent,
                                                    const GspSettings& settings);

/// What may be asked of the arm where it stands: speed, step and the range of each joint.
[[nodiscard]] RobotResult<void> check_turn(const TurnJoint6& command, const JointAngles& now_rad,
                                           const GspSettings& settings);

/// Is joint 6 at its target, and are joints 1 … 5 where they were?
[[nodiscard]] RobotResult<void> check_arrival(const TurnJoint6& command,
                                              const JointAngles& before_rad,
                                              const JointAngles& after_rad,
                                              const GspSettings& settings);

/// What a turn works with. `motion` is opened where it is not, and again after a loss.
struct TurnLinks {
    const GspSettings& settings;
    std::optional<GspChannel>& motion;
    GspMonitor& monitor;
};

/// Returns when the turn has an outcome, or when none can be had in time; then the error says
/// motion_unknown(). With a stop request, which the caller passes on to the controller, nothing is
/// sent again.
[[nodiscard]] RobotResult<Position> make_turn(const TurnLinks& links, const TurnJoint6& command,
                                              std::chrono::milliseconds motion_time,
                                              const std::stop_token& stop);

}  // namespace gripscan::gsp
