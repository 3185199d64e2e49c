#include "core/robot/gsp_reading.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/base/seeded_random.h"
#include "core/base/units.h"
#include "core/robot/kinematics.h"

namespace gripscan::gsp {
namespace {

using testing::HasSubstr;

/// Half a unit of the fourth decimal, in deg and mm, with room for the sum of three.
constexpr double kRounding = 1e-4;

JointAngles random_joints(SeededRandom& random) {
    JointAngles q{};
    for (double& angle : q) angle = random.uniform(-1.5, 1.5);
    return q;
}

TEST(GspReading, SurvivesTheWireToItsFourthDecimal) {
    for (std::uint64_t seed = 1; seed <= 50; ++seed) {
        SeededRandom random(seed);
        const JointAngles q = random_joints(random);
        const RobotReading sent{q, tool_pose(q)};
        const auto reply = decode_reply(encode(Reply(PositionReply{position_from(sent, 5)})));
        const auto read = reading_from(std::get<PositionReply>(*reply).position);
        ASSERT_TRUE(read);
        for (std::size_t i = 0; i < 6; ++i) {
            EXPECT_NEAR(deg_from_rad(read->joints_rad[i]), deg_from_rad(q[i]), kRounding);
        }
        const Pose difference = sent.T_world_tool.inverse() * read->T_world_tool;
        EXPECT_LT(difference.translation().norm() * kMmPerM, kRounding);
        // Near |P| = 90 deg the three angles are rounded apart, the rotation hardly is.
        EXPECT_LT(deg_from_rad(rotation_angle_rad(difference.linear())), 3 * kRounding);
    }
}

TEST(GspReading, WprNamesTheSameRotationAlsoWhereItIsNotUnique) {
    SeededRandom random(3);
    for (const double p_deg : {90.0, -90.0, 89.99999, -89.99999, 0.0, 45.0}) {
        for (int trial = 0; trial < 20; ++trial) {
            const double w_deg = random.uniform(-180.0, 180.0);
            const double r_deg = random.uniform(-180.0, 180.0);
            const Pose T = pose_from_xyzwpr({1, 2, 3, w_deg, p_deg, r_deg});
            const auto again = xyzwpr_from_pose(T);
            const Pose T_again = pose_from_xyzwpr(again);
            EXPECT_LT(rotation_angle_rad(T.linear().transpose() * T_again.linear()), 1e-6)
                << w_deg << " " << p_deg << " " << r_deg;
            if (std::abs(p_deg) == 90.0) {
                EXPECT_EQ(again[5], 0.0) << "R is set to 0 there";
            }
        }
    }
}

TEST(GspReading, WprTurnsAboutFixedAxesXThenYThenZ) {
    const Pose T = pose_from_xyzwpr({485, 0, 395, 180, 0, 30});
    EXPECT_NEAR(T.translation().x(), 0.485, 1e-12);
    // x first turned by W about X (nothing happens), then by R about Z.
    EXPECT_LT((T.linear() * Eigen::Vector3d::UnitX() -
               Eigen::Vector3d(std::cos(rad_from_deg(30)), std::sin(rad_from_deg(30)), 0))
                  .norm(),
              1e-12);
    EXPECT_LT((T.linear() * Eigen::Vector3d::UnitZ() + Eigen::Vector3d::UnitZ()).norm(), 1e-12);
}

TEST(GspReading, TakesThePoseFromTheJointsWhereTheControllerGivesNoneInWorld) {
    SeededRandom random(4);
    const JointAngles q = random_joints(random);
    Position position = position_from({q, Pose::Identity()}, 1);
    EXPECT_LT(reading_from(position)->T_world_tool.translation().norm(), 1e-12);
    position.uframe = 3;
    EXPECT_TRUE(reading_from(position)->T_world_tool.isApprox(tool_pose(q), 1e-9));
    position.uframe = 0;
    position.xyzwpr[4].reset();
    EXPECT_TRUE(reading_from(position)->T_world_tool.isApprox(tool_pose(q), 1e-9));
}

TEST(GspReading, NeedsAllSixJoints) {
    Position position = position_from({{}, Pose::Identity()}, 1);
    position.joints_deg[4].reset();
    const auto reading = reading_from(position);
    ASSERT_FALSE(reading);
    EXPECT_EQ(reading.error().fault, RobotFault::kProtocol);
    EXPECT_THAT(reading.error().message, HasSubstr("joint 5"));
}

TEST(GspReading, WhatIsUnknownForbidsAMotion) {
    const ControllerState state = state_from(StateReply{});
    EXPECT_FALSE(state.automatic);
    EXPECT_FALSE(state.servo_on);
    EXPECT_TRUE(state.emergency_stop);
    EXPECT_TRUE(state.fault);
    EXPECT_TRUE(state.moving);
    const ControllerState known =
        state_from(StateReply{true, true, false, false, false, 80, "SRVO-002"});
    EXPECT_TRUE(known.automatic && known.servo_on);
    EXPECT_FALSE(known.emergency_stop || known.fault || known.moving);
    EXPECT_EQ(known.override_percent, 80);
    EXPECT_EQ(known.alarm, "SRVO-002");
}

}  // namespace
}  // namespace gripscan::gsp
