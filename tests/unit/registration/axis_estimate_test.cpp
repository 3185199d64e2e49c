// The axis from noisy steps, some of them wrong, and how steps deviate from it.
#include "core/registration/axis_estimate.h"

#include <gtest/gtest.h>

#include "core/base/seeded_random.h"
#include "core/base/units.h"
#include "tests/support/random_pose.h"

namespace gripscan {
namespace {

using namespace test;

constexpr double kNoise_rad = 0.05 * kRadPerDeg;
constexpr double kNoise_m = 0.05e-3;

const Axis kAxis{Eigen::Vector3d(0.02, -0.03, 0.7), Eigen::Vector3d(1.0, 0.2, -0.1).normalized()};
const Eigen::Vector3d kCentre(0.05, -0.02, 0.69);

Pose noisy(const Pose& T, SeededRandom& random) {
    Vector6d noise;
    for (int i = 0; i < 3; ++i) noise(i) = kNoise_rad * random.normal();
    for (int i = 3; i < 6; ++i) noise(i) = kNoise_m * random.normal();
    return motion_about(noise, kCentre) * T;
}

std::vector<Pose> noisy_steps(SeededRandom& random, int count = 36, double deg = 10.0) {
    std::vector<Pose> steps;
    for (int i = 0; i < count; ++i) {
        steps.push_back(noisy(turn_about(kAxis, rad_from_deg(deg)), random));
    }
    return steps;
}

double tilt_rad(const Axis& a) {
    return std::acos(std::min(1.0, a.direction.dot(kAxis.direction)));
}

TEST(EstimateAxis, ExactStepsGiveItExactly) {
    const std::vector<Pose> steps{turn_about(kAxis, 0.1), turn_about(kAxis, 0.3)};
    const auto found = estimate_axis(steps, kCentre);
    ASSERT_TRUE(found);
    EXPECT_LT(tilt_rad(found->axis), 1e-7);
    EXPECT_LT(kAxis.distance_m(found->axis.point_m), 1e-9);
    // The point is the one nearest the centre.
    EXPECT_NEAR((found->axis.point_m - kCentre).dot(kAxis.direction), 0.0, 1e-9);
}

/// A step's axis tilts by noise/angle; the mean of n steps by that over sqrt(n), in each of two
/// directions. A step's axis point moves by noise_m/angle, likewise.
TEST(EstimateAxis, AveragesTheNoise) {
    const double step_rad = rad_from_deg(10.0);
    double tilts = 0.0;
    double offsets = 0.0;
    double sds_rad = 0.0;
    double sds_m = 0.0;
    constexpr int kSeeds = 30;
    for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
        SeededRandom random(seed);
        const auto found = estimate_axis(noisy_steps(random), kCentre);
        ASSERT_TRUE(found);
        tilts += std::pow(tilt_rad(found->axis), 2) / (2.0 * kSeeds);
        offsets += std::pow(kAxis.distance_m(found->axis.point_m), 2) / (2.0 * kSeeds);
        sds_rad += found->sd_rad / kSeeds;
        sds_m += found->sd_m / kSeeds;
    }
    // 60 numbers tell an rms to 9 %; reweighting costs a little.
    EXPECT_LT(std::sqrt(tilts), 1.4 * kNoise_rad / step_rad / 6.0);
    EXPECT_LT(std::sqrt(offsets), 1.4 * kNoise_m / step_rad / 6.0);
    EXPECT_GT(sds_rad, 0.5 * std::sqrt(tilts));
    EXPECT_LT(sds_rad, 2.0 * std::sqrt(tilts));
    EXPECT_GT(sds_m, 0.5 * std::sqrt(offsets));
    EXPECT_LT(sds_m, 2.0 * std::sqrt(offsets));
}

TEST(EstimateAxis, OutliersAreHeldDown) {
    for (std::uint64_t seed = 1; seed <= 10; ++seed) {
        SeededRandom random(seed);
        auto steps = noisy_steps(random);
        for (const std::size_t wrong : {5, 6, 20, 30}) steps[wrong] = random_pose(random, 0.6);
        const auto found = estimate_axis(steps, kCentre);
        ASSERT_TRUE(found);
        // 32 good steps: a tilt of 0.05 degrees, an offset of 0.05 mm at one sigma.
        EXPECT_LT(deg_from_rad(tilt_rad(found->axis)), 0.3) << "seed " << seed;
        EXPECT_LT(kMmPerM * kAxis.distance_m(found->axis.point_m), 0.4) << "seed " << seed;
    }
}

TEST(EstimateAxis, SignIsThatOfMostSteps) {
    SeededRandom random(3);
    auto steps = noisy_steps(random, 8);
    steps[2] = steps[2].inverse();
    steps[5] = steps[5].inverse();
    EXPECT_LT(deg_from_rad(tilt_rad(estimate_axis(steps, kCentre)->axis)), 1.0);
    for (Pose& step : steps) step = step.inverse();
    EXPECT_GT(deg_from_rad(tilt_rad(estimate_axis(steps, kCentre)->axis)), 179.0);
}

TEST(EstimateAxis, NothingWhereNothingTurns) {
    SeededRandom random(3);
    EXPECT_FALSE(estimate_axis({}, kCentre));
    const std::vector<Pose> still(3, turn_about(kAxis, rad_from_deg(0.05)));
    EXPECT_FALSE(estimate_axis(still, kCentre));
}

TEST(DeviationFrom, ReadsAngleTiltSlipAndOffset) {
    const double angle = rad_from_deg(10.0);
    EXPECT_NEAR(deviation_from(kAxis, turn_about(kAxis, angle)).angle_rad, angle, 1e-9);
    EXPECT_NEAR(deviation_from(kAxis, turn_about(kAxis, -angle)).angle_rad, -angle, 1e-9);

    Pose slipped = turn_about(kAxis, angle);
    slipped.translation() += 0.002 * kAxis.direction;
    const AxisDeviation slip = deviation_from(kAxis, slipped);
    EXPECT_NEAR(slip.slip_m, 0.002, 1e-9);
    EXPECT_NEAR(slip.offset_m, 0.0, 1e-9);

    Axis shifted = kAxis;
    shifted.point_m += 0.003 * kAxis.direction.unitOrthogonal();
    const AxisDeviation offset = deviation_from(kAxis, turn_about(shifted, angle));
    EXPECT_NEAR(offset.offset_m, 0.003, 1e-8);
    EXPECT_NEAR(offset.slip_m, 0.0, 1e-9);
    EXPECT_NEAR(offset.tilt_rad, 0.0, 1e-6);

    Axis tilted = kAxis;
    tilted.direction =
        rotation_from_vector(0.04 * kAxis.direction.unitOrthogonal()) * kAxis.direction;
    const AxisDeviation tilt = deviation_from(kAxis, turn_about(tilted, -angle));
    EXPECT_NEAR(tilt.tilt_rad, 0.04, 1e-8);
    EXPECT_NEAR(tilt.angle_rad, -angle, 1e-9);
}

}  // namespace
}  // namespace gripscan
