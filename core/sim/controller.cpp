#include "core/sim/controller.h"

#include <cmath>

#include "core/base/units.h"
#include "core/robot/kinematics.h"

namespace gripscan::sim {
namespace {

using gsp::ErrorCode;

constexpr std::string_view kModel = "LRMate200iC/5L";

template <class... Visitors>
struct Visitor : Visitors... {
    using Visitors::operator()...;
};

}  // namespace

std::optional<ErrorCode> refusal(const Conditions& conditions) {
    if (conditions.emergency_stop) return ErrorCode::kEmergencyStop;
    if (conditions.fault) return ErrorCode::kFault;
    if (conditions.pendant_enabled) return ErrorCode::kPendant;
    if (!conditions.automatic) return ErrorCode::kNotAutomatic;
    if (!conditions.servo_on) return ErrorCode::kServoOff;
    return std::nullopt;
}

Controller::Controller(ArmMotion& arm, const ControllerSettings& settings)
    : arm_(arm), settings_(settings) {}

gsp::Reply Controller::answer(LinkKind link, const gsp::Request& request, double now_s) {
    advance(now_s);
    const auto other_link = [](int id, const char* which) -> gsp::Reply {
        return gsp::Failure{id, ErrorCode::kUnknownRequest,
                            fmt::format("belongs to the {} link", which)};
    };
    return std::visit(
        Visitor{
            [](const gsp::Hello& hello) -> gsp::Reply {
                if (hello.version == gsp::kVersion) {
                    return gsp::HelloReply{std::string(kModel), gsp::kAxes,
                                           std::string(gsp::kVersionText)};
                }
                return gsp::Failure{0, ErrorCode::kVersion,
                                    fmt::format("speaks {}", gsp::kVersionText)};
            },
            [&](const gsp::AskState&) -> gsp::Reply { return state(now_s); },
            [&](const gsp::AskPosition&) -> gsp::Reply {
                return gsp::PositionReply{position(now_s)};
            },
            [&](const gsp::TurnJoint6& command) -> gsp::Reply {
                if (link != LinkKind::kMotion) return other_link(command.id, "motion");
                return accept(command, now_s);
            },
            [&](const gsp::Stop&) -> gsp::Reply {
                if (link != LinkKind::kMonitor) return other_link(0, "monitor");
                if (under_way()) end_turn(ErrorCode::kStopped, "stopped on request", now_s);
                return gsp::StopReply{};
            }},
        request);
}

gsp::Reply Controller::accept(const gsp::TurnJoint6& command, double now_s) {
    if (auto why_not = objection(command, now_s)) return *why_not;
    const bool again = turn_ && command.id == turn_->command.id;
    if (!again) {
        turn_ = Turn{command, std::nullopt};
        const double speed = command.speed_percent * conditions_.override_percent / 100.0;
        arm_.turn_joint6(rad_from_deg(command.angle_deg), speed, now_s);
    }
    awaited_ = true;
    return gsp::Accepted{command.id};
}

std::optional<gsp::Failure> Controller::objection(const gsp::TurnJoint6& command,
                                                  double now_s) const {
    const auto stale = [&](std::string_view why) {
        return gsp::Failure{command.id, ErrorCode::kStaleId,
                            gsp::stale_text(turn_->command.id, why)};
    };
    if (turn_ && command.id == turn_->command.id) {
        if (command == turn_->command) return std::nullopt;
        return stale("this id had other arguments");
    }
    if (turn_ && command.id < turn_->command.id) return stale("this id has passed");
    if (under_way()) {
        return gsp::Failure{command.id, ErrorCode::kBusy,
                            fmt::format("busy with {}", turn_->command.id)};
    }
    if (const auto code = refusal(conditions_)) {
        const std::string& alarm = conditions_.alarm;
        return gsp::Failure{command.id, *code,
                            alarm.empty() ? std::string(gsp::words_of(*code)) : alarm};
    }
    return out_of_limits(command, now_s);
}

std::optional<gsp::Failure> Controller::out_of_limits(const gsp::TurnJoint6& command,
                                                      double now_s) const {
    JointAngles target_rad = arm_.at(now_s).encoder_rad;
    const double from_deg = deg_from_rad(target_rad[5]);
    target_rad[5] = rad_from_deg(command.angle_deg);
    if (const Status ok = check_joint_ranges(target_rad); !ok) {
        return gsp::Failure{command.id, ErrorCode::kTargetRange,
                            fmt::format("J6 at {:.3f} deg is out of range", command.angle_deg)};
    }
    if (limits_deg_ && (command.angle_deg < limits_deg_->first ||
                        command.angle_deg > limits_deg_->second)) {
        return gsp::Failure{command.id, ErrorCode::kTargetRange,
                            fmt::format("J6 is limited to {:.3f} .. {:.3f} deg",
                                        limits_deg_->first, limits_deg_->second)};
    }
    if (std::abs(command.angle_deg - from_deg) > settings_.max_step_deg) {
        return gsp::Failure{command.id, ErrorCode::kStepCap,
                            fmt::format("one turn is at most {:g} deg", settings_.max_step_deg)};
    }
    if (command.speed_percent < 1.0 || command.speed_percent > settings_.max_speed_percent) {
        return gsp::Failure{command.id, ErrorCode::kSpeedRange,
                            fmt::format("the speed is 1 .. {:g}", settings_.max_speed_percent)};
    }
    return std::nullopt;
}

gsp::StateReply Controller::state(double now_s) const {
    return {.automatic = conditions_.automatic,
            .servo_on = conditions_.servo_on,
            .emergency_stop = conditions_.emergency_stop,
            .fault = conditions_.fault,
            .moving = arm_.at(now_s).moving,
            .override_percent = conditions_.override_percent,
            .alarm = conditions_.alarm};
}

gsp::Position Controller::position(double now_s) const {
    const JointAngles joints_rad = arm_.at(now_s).encoder_rad;
    const Pose T_world_tool = tool_pose(joints_rad);
    const EulerAngles wpr = euler_from_rotation(T_world_tool.linear());
    const std::array<double, 3> wpr_rad = {wpr.roll_rad, wpr.pitch_rad, wpr.yaw_rad};
    gsp::Position position;
    position.time_ms = std::llround(now_s * 1000.0);
    for (std::size_t i = 0; i < 6; ++i) position.joints_deg[i] = deg_from_rad(joints_rad[i]);
    for (std::size_t i = 0; i < 3; ++i) {
        position.xyzwpr[i] = T_world_tool.translation()[static_cast<int>(i)] * kMmPerM;
        position.xyzwpr[3 + i] = deg_from_rad(wpr_rad[i]);
    }
    position.uframe = 0;
    position.utool = 1;
    return position;
}

std::optional<gsp::Reply> Controller::outcome(double now_s) {
    advance(now_s);
    if (!awaited_ || !turn_ || !turn_->end) return std::nullopt;
    awaited_ = false;
    return turn_->end;
}

void Controller::set_conditions(const Conditions& conditions, double now_s, double for_s) {
    conditions_ = conditions;
    usual_again_s_.reset();
    if (for_s > 0.0) usual_again_s_ = now_s + for_s;
    const auto code = refusal(conditions_);
    if (!code || !under_way()) return;
    end_turn(*code,
             conditions_.alarm.empty() ? std::string(gsp::words_of(*code)) : conditions_.alarm,
             now_s);
}

void Controller::limit_joint6(double margin_deg, double now_s) {
    const double here_deg = deg_from_rad(arm_.at(now_s).joint6_rad);
    limits_deg_ = {here_deg - margin_deg, here_deg + margin_deg};
}

void Controller::restart(double now_s) {
    arm_.stop(now_s);
    turn_.reset();
    awaited_ = false;
    conditions_ = {};
    usual_again_s_.reset();
}

bool Controller::half_way(double now_s) const {
    return under_way() && now_s >= arm_.began_s() + arm_.duration_s() / 2.0;
}

bool Controller::arrived(double now_s) const {
    return under_way() && now_s >= arm_.began_s() + arm_.duration_s() + settings_.settle_s;
}

void Controller::end_turn(ErrorCode code, std::string text, double now_s) {
    arm_.stop(now_s);
    turn_->end = gsp::Failure{turn_->command.id, code, std::move(text)};
}

void Controller::advance(double now_s) {
    if (usual_again_s_ && now_s >= *usual_again_s_) set_conditions({}, now_s);
    if (under_way() && now_s > arm_.began_s() + settings_.max_turn_s) {
        end_turn(ErrorCode::kMotionTime,
                 fmt::format("not there after {:g} s", settings_.max_turn_s), now_s);
    }
    if (!arrived(now_s)) return;
    const double off_deg =
        deg_from_rad(arm_.at(now_s).encoder_rad[5]) - turn_->command.angle_deg;
    if (std::abs(off_deg) > settings_.tolerance_deg) {
        end_turn(ErrorCode::kOffTarget, fmt::format("J6 stands {:.3f} deg off", off_deg), now_s);
    } else {
        turn_->end = gsp::Done{turn_->command.id, position(now_s)};
    }
}

}  // namespace gripscan::sim
