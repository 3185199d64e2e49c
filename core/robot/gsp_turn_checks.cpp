// What is checked on this side, before anything is sent and when it is done.
#include <fmt/format.h>

#include <cmath>

#include "core/base/units.h"
#include "core/robot/gsp_turn.h"
#include "core/robot/kinematics.h"

namespace gripscan::gsp {
namespace {

tl::unexpected<RobotError> failed(RobotFault fault, std::string message) {
    return tl::unexpected<RobotError>(RobotError{fault, 0, 0, std::move(message)});
}

/// What the wire's four decimals may add to a difference.
constexpr double kRounding_deg = 1e-4;

}  // namespace

std::chrono::milliseconds motion_time(double turn_deg, double speed_percent,
                                      std::optional<int> override_percent,
                                      const GspSettings& settings) {
    const double override_share =
        override_percent.value_or(0) > 0 ? *override_percent / 100.0 : 1.0;
    const double speed_deg_s = settings.joint6_speed_deg_s * speed_percent / 100.0 * override_share;
    return std::chrono::ceil<std::chrono::milliseconds>(
        std::chrono::duration<double>(std::abs(turn_deg) / speed_deg_s));
}

RobotResult<void> check_turn(const TurnJoint6& command, const JointAngles& now_rad,
                             const GspSettings& settings) {
    if (!(command.speed_percent >= 1.0 && command.speed_percent <= settings.max_speed_percent)) {
        return failed(RobotFault::kOutOfRange,
                      fmt::format("speed {} % is outside 1 … {} %; nothing moved",
                                  command.speed_percent, settings.max_speed_percent));
    }
    JointAngles target_rad = now_rad;
    target_rad[5] = rad_from_deg(command.angle_deg);
    if (const Status in_range = check_joint_ranges(target_rad); !in_range) {
        return failed(RobotFault::kOutOfRange, in_range.error().message + "; nothing moved");
    }
    const double step_deg = std::abs(command.angle_deg - deg_from_rad(now_rad[5]));
    if (step_deg > settings.max_step_deg + settings.target_tolerance_deg) {
        return failed(RobotFault::kOutOfRange,
                      fmt::format("a step of {:.3f} deg is above the cap of {} deg; nothing moved, "
                                  "take smaller steps",
                                  step_deg, settings.max_step_deg));
    }
    return {};
}

RobotResult<void> check_arrival(const TurnJoint6& command, const JointAngles& before_rad,
                                const JointAngles& after_rad, const GspSettings& settings) {
    for (std::size_t i = 0; i < 5; ++i) {
        const double moved_deg = deg_from_rad(after_rad[i] - before_rad[i]);
        if (std::abs(moved_deg) > settings.other_joint_tolerance_deg + kRounding_deg) {
            return failed(
                RobotFault::kOtherJoint,
                fmt::format("joint {} moved by {:+.4f} deg during turn {} of joint 6, {} "
                            "deg are allowed; this step is void",
                            i + 1, moved_deg, command.id, settings.other_joint_tolerance_deg));
        }
    }
    const double off_deg = deg_from_rad(after_rad[5]) - command.angle_deg;
    if (std::abs(off_deg) > settings.target_tolerance_deg + kRounding_deg) {
        return failed(
            RobotFault::kOffTarget,
            fmt::format("turn {} ended {:+.4f} deg off its target of {:.4f} deg, {} deg "
                        "are allowed",
                        command.id, off_deg, command.angle_deg, settings.target_tolerance_deg));
    }
    return {};
}

}  // namespace gripscan::gsp
