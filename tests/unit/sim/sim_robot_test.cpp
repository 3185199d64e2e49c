#include "core/sim/sim_robot.h"

#include <gtest/gtest.h>

#include "core/base/units.h"
#include "core/robot/kinematics.h"

namespace gripscan::sim {
namespace {

constexpr JointAngles kStart = {0.1, -0.2, 0.3, 0.4, -0.5, 0.0};

TEST(SimRobot, StopsWhereItIsToldUpToItsRepeatability) {
    SimRobot robot(kStart, 4);
    double sum2 = 0.0;
    double encoder2 = 0.0;
    constexpr int kMoves = 2000;
    for (int i = 0; i < kMoves; ++i) {
        const double target_rad = rad_from_deg(-300.0 + 0.3 * i);
        const auto reading = robot.turn_joint6({1, target_rad}, {});
        ASSERT_TRUE(reading);
        const ArmState& state = robot.arm();
        sum2 += std::pow(deg_from_rad(state.true_rad[5] - target_rad), 2);
        encoder2 += std::pow(deg_from_rad(state.encoder_rad[5] - state.true_rad[5]), 2);
        EXPECT_EQ(reading->joints_rad, state.encoder_rad);
        for (std::size_t j = 0; j < 5; ++j) EXPECT_EQ(state.true_rad[j], kStart[j]);
    }
    // 2000 draws: their standard deviation is known to 1.6 %.
    EXPECT_NEAR(std::sqrt(sum2 / kMoves), SimRobot::kRepeatability_deg, 0.0004);
    EXPECT_NEAR(std::sqrt(encoder2 / kMoves), SimRobot::kEncoder_deg, 0.0001);
}

TEST(SimRobot, ErrorsBelongToTheAngleAndTheSeed) {
    SimRobot robot(kStart, 4);
    const JointAngles there = robot.turn_joint6({1, 1.0}, {})->joints_rad;
    (void)robot.turn_joint6({1, 2.0}, {});
    EXPECT_EQ(robot.turn_joint6({1, 1.0}, {})->joints_rad, there);
    EXPECT_NE(SimRobot(kStart, 5).turn_joint6({1, 1.0}, {})->joints_rad, there);
}

TEST(SimRobot, RefusesToLeaveItsRangeAndStaysWhereItIs) {
    SimRobot robot(kStart, 4);
    ASSERT_TRUE(robot.turn_joint6({1, rad_from_deg(360.0)}, {}));
    const JointAngles before = robot.read()->joints_rad;
    for (const double deg : {360.1, -361.0, std::nan("")}) {
        const auto refused = robot.turn_joint6({1, rad_from_deg(deg)}, {});
        ASSERT_FALSE(refused);
        EXPECT_EQ(refused.error().fault, RobotFault::kOutOfRange);
        EXPECT_NE(refused.error().message.find("joint 6"), std::string::npos);
        EXPECT_EQ(robot.read()->joints_rad, before);
    }
}

TEST(SimRobot, ReportsTheToolWhereItsEncodersPutIt) {
    SimRobot robot(kStart, 4);
    const auto reading = robot.turn_joint6({1, 0.7}, {});
    ASSERT_TRUE(reading);
    EXPECT_TRUE(reading->T_world_tool.isApprox(tool_pose(reading->joints_rad), 1e-12));
}

}  // namespace
}  // namespace gripscan::sim
