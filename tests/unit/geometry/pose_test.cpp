#include "core/geometry/pose.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "core/base/units.h"
#include "core/geometry/axis.h"
#include "core/geometry/box.h"
#include "tests/support/random_pose.h"

namespace gripscan {
namespace {

using std::numbers::pi;

TEST(Axis, APointIsItsPlaceAlongTheAxisAndItsDistance) {
    SeededRandom random(5);
    for (int i = 0; i < 200; ++i) {
        const Axis axis{random.normal() * Eigen::Vector3d::Ones(), test::random_direction(random)};
        const Eigen::Vector3d across =
            axis.direction.cross(test::random_direction(random)).normalized();
        const double along_m = random.uniform(-2.0, 2.0);
        const double away_m = random.uniform(0.0, 2.0);
        const Eigen::Vector3d p_m = axis.point_m + along_m * axis.direction + away_m * across;
        EXPECT_NEAR(axis.along_m(p_m), along_m, 1e-13);
        EXPECT_NEAR(axis.distance_m(p_m), away_m, 1e-13);
    }
}

TEST(EulerAngles, ReadBackBothWays) {
    SeededRandom random(1);
    for (int i = 0; i < 2000; ++i) {
        const EulerAngles angles{random.uniform(-pi, pi), random.uniform(-1.5, 1.5),
                                 random.uniform(-pi, pi)};
        const EulerAngles read = euler_from_rotation(rotation_from_euler(angles));
        // cos(1.5) = 0.07 magnifies the rounding of roll and yaw.
        EXPECT_NEAR(read.roll_rad, angles.roll_rad, 1e-13);
        EXPECT_NEAR(read.pitch_rad, angles.pitch_rad, 1e-13);
        EXPECT_NEAR(read.yaw_rad, angles.yaw_rad, 1e-13);

        const Eigen::Matrix3d R = test::random_pose(random, pi).linear();
        EXPECT_TRUE(rotation_from_euler(euler_from_rotation(R)).isApprox(R, 1e-12));
    }
}

TEST(EulerAngles, TurnAboutTheAxesOfThePaper) {
    const auto R = [](double roll, double pitch, double yaw) {
        return rotation_from_euler({roll, pitch, yaw});
    };
    EXPECT_TRUE((R(pi / 2, 0, 0) * Eigen::Vector3d::UnitY()).isApprox(Eigen::Vector3d::UnitZ()));
    EXPECT_TRUE((R(0, pi / 2, 0) * Eigen::Vector3d::UnitZ()).isApprox(Eigen::Vector3d::UnitX()));
    EXPECT_TRUE((R(0, 0, pi / 2) * Eigen::Vector3d::UnitX()).isApprox(Eigen::Vector3d::UnitY()));
    // Roll first, then pitch, then yaw, all about the fixed axes.
    EXPECT_TRUE(R(0.3, 0.2, 0.1).isApprox(R(0, 0, 0.1) * R(0, 0.2, 0) * R(0.3, 0, 0)));
}

TEST(EulerAngles, AtTheGimbalYawIsZeroAndTheRotationComesBack) {
    SeededRandom random(2);
    for (const double pitch : {pi / 2, -pi / 2}) {
        for (int i = 0; i < 100; ++i) {
            const Eigen::Matrix3d R =
                rotation_from_euler({random.uniform(-pi, pi), pitch, random.uniform(-pi, pi)});
            const EulerAngles read = euler_from_rotation(R);
            EXPECT_EQ(read.yaw_rad, 0.0);
            EXPECT_NEAR(read.pitch_rad, pitch, 1e-7);
            EXPECT_TRUE(rotation_from_euler(read).isApprox(R, 1e-8));
        }
    }
}

TEST(RotationVector, IsTheInverseOfTheExponential) {
    SeededRandom random(3);
    for (int i = 0; i < 2000; ++i) {
        const Eigen::Vector3d w = test::random_direction(random) * random.uniform(0.0, pi - 1e-6);
        EXPECT_LT((rotation_vector(rotation_from_vector(w)) - w).norm(), 1e-9);
        EXPECT_NEAR(rotation_angle_rad(rotation_from_vector(w)), w.norm(), 1e-9);
    }
    EXPECT_TRUE(rotation_from_vector(Eigen::Vector3d::Zero()).isIdentity());
    EXPECT_TRUE(rotation_vector(Eigen::Matrix3d::Identity()).isZero());
}

TEST(RotationVector, KeepsSmallAnglesExactly) {
    // acos of the trace would lose everything below 1e-8.
    for (const double angle : {1e-3, 1e-6, 1e-9, 1e-12, 1e-15}) {
        const Eigen::Vector3d w = Eigen::Vector3d(1, 2, 2) / 3.0 * angle;
        EXPECT_LT((rotation_vector(rotation_from_vector(w)) - w).norm(), 1e-6 * angle) << angle;
    }
}

TEST(RotationVector, HalfTurnsHaveTheirAngle) {
    SeededRandom random(4);
    for (int i = 0; i < 200; ++i) {
        const Eigen::Vector3d axis = test::random_direction(random);
        const Eigen::Matrix3d R = rotation_from_vector(pi * axis);
        EXPECT_NEAR(rotation_angle_rad(R), pi, 1e-7);
        EXPECT_NEAR(std::abs(rotation_vector(R).normalized().dot(axis)), 1.0, 1e-9);
    }
}

TEST(MotionAbout, TurnsAboutItsCentre) {
    SeededRandom random(5);
    for (int i = 0; i < 200; ++i) {
        const Eigen::Vector3d centre = test::random_pose(random, 1.0).translation();
        Vector6d motion;
        motion << test::random_direction(random) * 0.1, test::random_direction(random) * 0.01;
        const Pose T = motion_about(motion, centre);
        EXPECT_TRUE((T * centre).isApprox(centre + motion.tail<3>(), 1e-12));
        EXPECT_TRUE(rotation_vector(T.linear()).isApprox(motion.head<3>(), 1e-9));
    }
}

TEST(Pose, InverseAndCompositionFollowTheirNames) {
    SeededRandom random(6);
    for (int i = 0; i < 200; ++i) {
        const Pose T_a_b = test::random_pose(random, pi);
        const Pose T_b_c = test::random_pose(random, pi);
        const Eigen::Vector3d p_c = test::random_pose(random, 1.0).translation();
        EXPECT_TRUE((T_a_b * (T_b_c * p_c)).isApprox((T_a_b * T_b_c) * p_c, 1e-12));
        EXPECT_TRUE((T_a_b * T_a_b.inverse()).isApprox(Pose::Identity(), 1e-12));
        EXPECT_TRUE(((T_a_b * T_b_c).inverse()).isApprox(T_b_c.inverse() * T_a_b.inverse(), 1e-12));
    }
}

TEST(RowMajor, ReadsBackAndHasTheShiftInTheLastColumn) {
    SeededRandom random(7);
    for (int i = 0; i < 200; ++i) {
        const Pose T = test::random_pose(random, pi);
        const auto numbers = row_major_from_pose(T);
        EXPECT_EQ(numbers[3], T.translation().x());
        EXPECT_EQ(numbers[7], T.translation().y());
        EXPECT_EQ(numbers[11], T.translation().z());
        EXPECT_EQ(numbers[15], 1.0);
        const auto read = pose_from_row_major(numbers);
        ASSERT_TRUE(read.has_value());
        EXPECT_TRUE(read->isApprox(T, 1e-12));
    }
}

TEST(RowMajor, RoundedNumbersBecomeARotationAgain) {
    SeededRandom random(8);
    const auto numbers = row_major_from_pose(test::random_pose(random, pi));
    auto rounded = numbers;
    for (double& x : rounded) x = std::round(x * 1e8) / 1e8;
    const auto read = pose_from_row_major(rounded);
    ASSERT_TRUE(read.has_value());
    const Eigen::Matrix3d R = read->linear();
    EXPECT_TRUE((R * R.transpose()).isIdentity(1e-14));
}

TEST(RowMajor, RefusesWhatIsNoRigidMotion) {
    const auto identity = row_major_from_pose(Pose::Identity());
    const auto with = [&](std::size_t i, double value) {
        auto numbers = identity;
        numbers[i] = value;
        return numbers;
    };
    EXPECT_TRUE(pose_from_row_major(identity).has_value());
    EXPECT_FALSE(pose_from_row_major(with(0, -1.0)).has_value()) << "mirrored";
    EXPECT_FALSE(pose_from_row_major(with(0, 1.001)).has_value()) << "scaled";
    EXPECT_FALSE(pose_from_row_major(with(1, 0.01)).has_value()) << "sheared";
    EXPECT_FALSE(pose_from_row_major(with(12, 0.1)).has_value()) << "column-major";
    EXPECT_FALSE(pose_from_row_major(with(15, 0.0)).has_value()) << "last row";
    for (const double bad :
         {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
        for (const std::size_t i : {0, 3, 15}) {
            EXPECT_FALSE(pose_from_row_major(with(i, bad)).has_value());
        }
    }
    EXPECT_FALSE(pose_from_row_major({}).has_value()) << "all zero";
}

TEST(TurnAbout, KeepsTheAxisAndTurnsByTheAngle) {
    SeededRandom random(9);
    for (int i = 0; i < 200; ++i) {
        const Axis axis{test::random_pose(random, 1.0).translation(),
                        test::random_direction(random)};
        const double angle = random.uniform(-3.0, 3.0);
        const Pose T = turn_about(axis, angle);
        const Eigen::Vector3d on_axis = axis.point_m + 0.7 * axis.direction;
        EXPECT_TRUE((T * on_axis).isApprox(on_axis, 1e-12));
        EXPECT_TRUE(rotation_vector(T.linear()).isApprox(angle * axis.direction, 1e-9));
        const Eigen::Vector3d p = test::random_pose(random, 1.0).translation();
        EXPECT_NEAR(axis.distance_m(T * p), axis.distance_m(p), 1e-12);
    }
}

TEST(Box, KnowsWhatIsInside) {
    const Box box{{-1, -2, -3}, {1, 2, 3}};
    EXPECT_TRUE(box.valid());
    EXPECT_TRUE(box.contains({0, 0, 0}));
    EXPECT_TRUE(box.contains({1, 2, 3}));
    EXPECT_FALSE(box.contains({1.001, 0, 0}));
    EXPECT_FALSE(box.contains({0, 0, std::nan("")}));
    for (const auto& corner : box.corners()) EXPECT_TRUE(box.contains(corner));
    EXPECT_FALSE(Box{}.valid());
    EXPECT_FALSE((Box{{0, 0, 0}, {1, 1, -1}}.valid()));
    EXPECT_FALSE((Box{{0, 0, 0}, {1, 1, std::nan("")}}.valid()));
}

}  // namespace
}  // namespace gripscan
