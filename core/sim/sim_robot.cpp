#include "core/sim/sim_robot.h"

#include <cmath>

#include "core/base/seeded_random.h"
#include "core/base/units.h"
#include "core/robot/kinematics.h"

namespace gripscan::sim {

SimRobot::SimRobot(const JointAngles& joints_rad, std::uint64_t seed)
    : state_{joints_rad, joints_rad}, seed_(seed) {
    stand_at(joints_rad[5]);
}

RobotResult<RobotIdentity> SimRobot::connect() {
    return RobotIdentity{"LRMate200iC/5L", 6, "direct"};
}

RobotResult<ControllerState> SimRobot::state() {
    ControllerState state;
    state.automatic = state.servo_on = true;
    state.override_percent = 100;
    return state;
}

RobotResult<RobotReading> SimRobot::read() {
    return RobotReading{state_.encoder_rad, tool_pose(state_.encoder_rad)};
}

RobotResult<RobotReading> SimRobot::turn_joint6(const Joint6Command& command, std::stop_token) {
    JointAngles target = state_.true_rad;
    target[5] = command.angle_rad;
    if (const Status ok = check_joint_ranges(target); !ok) {
        return tl::unexpected<RobotError>(
            {RobotFault::kOutOfRange, 300, 0,
             fmt::format("the simulated robot refuses to move: {}", ok.error().message)});
    }
    stand_at(command.angle_rad);
    return read();
}

void SimRobot::stand_at(double angle_rad) {
    constexpr double kSameAngle_rad = 1e-7;
    const auto number = static_cast<std::int64_t>(std::llround(angle_rad / kSameAngle_rad));
    SeededRandom random(SeededRandom(seed_ ^ static_cast<std::uint64_t>(number)).next());
    state_.true_rad[5] = angle_rad + rad_from_deg(kRepeatability_deg) * random.normal();
    state_.encoder_rad[5] = state_.true_rad[5] + rad_from_deg(kEncoder_deg) * random.normal();
}

}  // namespace gripscan::sim
