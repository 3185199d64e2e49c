#include "core/sim/arm_motion.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/base/seeded_random.h"
#include "core/base/units.h"

namespace gripscan::sim {
namespace {

constexpr JointAngles kStart = {0.1, -0.2, 0.3, 0.4, -0.5, 0.0};

TEST(MotionProfile, IsMonotoneKeepsItsLimitsAndEndsExactly) {
    SeededRandom random(11);
    for (int i = 0; i < 200; ++i) {
        const MotionProfile profile{random.uniform(-6, 6), random.uniform(-6, 6),
                                    random.uniform(0.1, 12), random.uniform(1, 40)};
        const double end_s = profile.duration_s();
        const double sign = profile.to_rad > profile.from_rad ? 1.0 : -1.0;
        EXPECT_EQ(profile.position_rad(0.0), profile.from_rad);
        EXPECT_EQ(profile.position_rad(end_s), profile.to_rad);
        EXPECT_EQ(profile.position_rad(end_s + 9.0), profile.to_rad);
        constexpr int kSamples = 300;
        const double dt = end_s / kSamples;
        double before = profile.from_rad;
        double speed_before = 0.0;
        for (int k = 1; k <= kSamples; ++k) {
            const double here = profile.position_rad(k * dt);
            const double speed = sign * (here - before) / dt;
            EXPECT_GE(speed, -1e-9);
            EXPECT_LE(speed, profile.speed_rad_s * (1.0 + 1e-9));
            EXPECT_LE(std::abs(speed - speed_before) / dt,
                      profile.acceleration_rad_s2 * (1.0 + 1e-6));
            before = here;
            speed_before = speed;
        }
    }
}

TEST(MotionProfile, TakesTheTimeThatItsTrapezoidTakes) {
    // 10 rad at 2 rad/s and 4 rad/s²: 0.5 s up, 0.5 s down, 9 rad between.
    EXPECT_NEAR((MotionProfile{0, 10, 2, 4}.duration_s()), 5.5, 1e-12);
    // 1 rad at 4 rad/s²: half-way after √(2·0.5/4) s.
    EXPECT_NEAR((MotionProfile{0, -1, 99, 4}.duration_s()), 1.0, 1e-12);
    EXPECT_EQ((MotionProfile{3, 3, 1, 1}.duration_s()), 0.0);
}

TEST(ArmMotion, StopsWhereItIsToldUpToItsRepeatability) {
    ArmMotion arm(kStart, 4);
    double now_s = 0.0;
    double sum2 = 0.0;
    double encoder2 = 0.0;
    constexpr int kMoves = 2000;
    for (int i = 0; i < kMoves; ++i) {
        const double target_rad = rad_from_deg(-300.0 + 0.3 * i);
        arm.turn_joint6(target_rad, 50.0, now_s);
        now_s += arm.duration_s() + ArmMotion::kSettle_s;
        const ArmState state = arm.at(now_s);
        EXPECT_FALSE(state.moving);
        EXPECT_EQ(state.joint6_rad, target_rad);
        sum2 += std::pow(deg_from_rad(state.true_rad[5] - target_rad), 2);
        encoder2 += std::pow(deg_from_rad(state.encoder_rad[5] - state.true_rad[5]), 2);
        for (std::size_t j = 0; j < 5; ++j) EXPECT_EQ(state.true_rad[j], kStart[j]);
    }
    // 2000 draws: their standard deviation is known to 1.6 %.
    EXPECT_NEAR(std::sqrt(sum2 / kMoves), ArmMotion::kRepeatability_deg, 0.0004);
    EXPECT_NEAR(std::sqrt(encoder2 / kMoves), ArmMotion::kEncoder_deg, 0.0001);
}

TEST(ArmMotion, AStandingArmIsAFunctionOfItsAngleAndSeed) {
    ArmMotion direct(kStart, 4);
    direct.turn_joint6(1.0, 10.0, 0.0);
    ArmMotion detour(kStart, 4);
    detour.turn_joint6(0.4, 80.0, 3.0);
    detour.turn_joint6(1.0, 20.0, 9.0);
    ArmMotion other(kStart, 5);
    other.turn_joint6(1.0, 10.0, 0.0);
    constexpr double kLater_s = 100.0;
    EXPECT_EQ(direct.at(kLater_s).true_rad, detour.at(kLater_s).true_rad);
    EXPECT_EQ(direct.at(kLater_s).encoder_rad, detour.at(kLater_s).encoder_rad);
    EXPECT_NE(direct.at(kLater_s).true_rad, other.at(kLater_s).true_rad);
}

TEST(ArmMotion, TremblesAfterATravelAndThenStandsExactly) {
    ArmMotion arm(kStart, 4);
    arm.turn_joint6(rad_from_deg(10.0), 30.0, 0.0);
    const double end_s = arm.duration_s();
    const double rest_rad = arm.at(end_s + ArmMotion::kSettle_s).true_rad[5];
    double most_deg = 0.0;
    for (double t = 0.0; t < ArmMotion::kSettle_s; t += 0.001) {
        const ArmState state = arm.at(end_s + t);
        most_deg = std::max(most_deg, std::abs(deg_from_rad(state.true_rad[5] - rest_rad)));
        EXPECT_FALSE(state.moving);
    }
    EXPECT_GT(most_deg, 0.01);
    EXPECT_LT(most_deg, ArmMotion::kTremble_deg);
    for (const double later_s : {0.0, 0.01, 1.0, 1000.0}) {
        EXPECT_EQ(arm.at(end_s + ArmMotion::kSettle_s + later_s).true_rad[5], rest_rad);
    }
}

TEST(ArmMotion, StoppedItStandsWhereItWas) {
    ArmMotion arm(kStart, 4);
    arm.turn_joint6(2.0, 10.0, 5.0);
    const double half_s = 5.0 + arm.duration_s() / 2.0;
    EXPECT_TRUE(arm.at(half_s).moving);
    const double there_rad = arm.at(half_s).joint6_rad;
    EXPECT_NEAR(there_rad, 1.0, 1e-9);
    arm.stop(half_s);
    EXPECT_FALSE(arm.at(half_s).moving);
    EXPECT_EQ(arm.at(half_s + 50.0).joint6_rad, there_rad);
    // A standing arm is not stopped once more.
    arm.stop(half_s + 60.0);
    EXPECT_EQ(arm.at(half_s + 70.0).joint6_rad, there_rad);
}

}  // namespace
}  // namespace gripscan::sim
