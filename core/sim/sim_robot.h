// The simulated arm as its own controller sees it: joints that go where they are told, nearly, and
// encoders that read where they are, nearly. The true joints stay in here and with the renderer.
#pragma once

#include <cstdint>

#include "core/robot/robot_link.h"

namespace gripscan::sim {

/// Where the arm really stands, and what its encoders say.
struct ArmState {
    JointAngles true_rad{};
    JointAngles encoder_rad{};
};

class SimRobot : public RobotLink {
  public:
    /// Standard deviations of joint 6: where it stops, and what its encoder reads.
    static constexpr double kRepeatability_deg = 0.005;
    static constexpr double kEncoder_deg = 0.001;

    SimRobot(const JointAngles& joints_rad, std::uint64_t seed);

    [[nodiscard]] RobotResult<RobotIdentity> connect() override;
    void disconnect() override {}
    [[nodiscard]] RobotResult<ControllerState> state() override;
    [[nodiscard]] RobotResult<RobotReading> read() override;
    /// An angle outside ±360° is an error, and the arm stays where it is. The errors belong to the
    /// angle, not to the number of moves, so that a resumed turn equals an uninterrupted one.
    [[nodiscard]] RobotResult<RobotReading> turn_joint6(const Joint6Command& command,
                                                        std::stop_token stop) override;
    [[nodiscard]] RobotResult<void> stop() override { return {}; }
    void on_beat(std::function<void(const RobotBeat&)>) override {}

    [[nodiscard]] const ArmState& arm() const { return state_; }

  private:
    void stand_at(double angle_rad);

    ArmState state_;
    std::uint64_t seed_;
};

}  // namespace gripscan::sim
