#include "core/robot/inverse_kinematics.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/base/seeded_random.h"
#include "core/base/units.h"

namespace gripscan {
namespace {

JointAngles joints_deg(double j1, double j2, double j3, double j4, double j5, double j6) {
    return {rad_from_deg(j1), rad_from_deg(j2), rad_from_deg(j3),
            rad_from_deg(j4), rad_from_deg(j5), rad_from_deg(j6)};
}

/// Anywhere within the ranges; joint 3 so that the elbow's own angle is.
JointAngles random_joints(SeededRandom& random) {
    JointAngles q{};
    for (std::size_t i = 0; i < q.size(); ++i) {
        q[i] = random.uniform(joint_ranges()[i].min_rad, joint_ranges()[i].max_rad);
    }
    q[2] -= q[1];
    return q;
}

double largest_difference(const JointAngles& a, const JointAngles& b) {
    double largest = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i) largest = std::max(largest, std::abs(a[i] - b[i]));
    return largest;
}

TEST(InverseKinematics, EverySolutionLeadsBackToThePose) {
    SeededRandom random(11);
    for (int trial = 0; trial < 2000; ++trial) {
        const Pose T = tool_pose(random_joints(random));
        const auto all = inverse_kinematics(T);
        ASSERT_FALSE(all.empty());
        for (const ArmSolution& solution : all) {
            // Rounding of a handful of sines and arc functions, on lengths below a metre.
            EXPECT_LT((tool_pose(solution.joints_rad).matrix() - T.matrix()).norm(), 1e-9);
            EXPECT_EQ(solution.obstacle.empty(),
                      check_joint_ranges(solution.joints_rad).has_value());
        }
    }
}

TEST(InverseKinematics, TheJointsThatMadeThePoseAreAmongTheSolutions) {
    SeededRandom random(12);
    for (int trial = 0; trial < 2000; ++trial) {
        const JointAngles q = random_joints(random);
        if (std::abs(std::sin(q[4])) < 1e-3) continue;  // joints 4 and 6 are then not unique
        const auto all = inverse_kinematics(tool_pose(q), q);
        const bool found = std::any_of(all.begin(), all.end(), [&](const ArmSolution& s) {
            return s.obstacle.empty() && largest_difference(s.joints_rad, q) < 1e-6;
        });
        EXPECT_TRUE(found) << "trial " << trial;
    }
}

TEST(InverseKinematics, SolutionsAreDifferentWays) {
    const Pose T = tool_pose(joints_deg(30, 20, -10, 40, -50, 60));
    const auto all = inverse_kinematics(T);
    // Forward or over the back, elbow up or down, two wrists, full turns of joints 4 and 6.
    EXPECT_GE(all.size(), 8U);
    for (std::size_t i = 0; i < all.size(); ++i) {
        for (std::size_t j = 0; j < i; ++j) {
            EXPECT_GT(largest_difference(all[i].joints_rad, all[j].joints_rad), 1e-3);
        }
    }
}

TEST(InverseKinematics, AStraightWristKeepsJointFourAndTurnsJointSix) {
    const JointAngles q = joints_deg(10, 15, -20, 35, 0, 50);
    const Reachability reach = reachability(tool_pose(q), q);
    ASSERT_TRUE(reach.reachable);
    EXPECT_LT(largest_difference(reach.joints_rad, q), 1e-6);
}

TEST(InverseKinematics, TheNearestSolutionComesFirst) {
    SeededRandom random(13);
    for (int trial = 0; trial < 200; ++trial) {
        const JointAngles q = random_joints(random);
        if (std::abs(std::sin(q[4])) < 1e-2) continue;
        const Reachability reach = reachability(tool_pose(q), q);
        ASSERT_TRUE(reach.reachable) << reach.sentence;
        EXPECT_LT(largest_difference(reach.joints_rad, q), 1e-6);
    }
}

TEST(InverseKinematics, BeyondTheArmItSaysByHowMuch) {
    Pose T = tool_pose(joints_deg(0, 0, 0, 0, 0, 0));
    T.translation().x() += 0.6;
    const Reachability reach = reachability(T, {});
    EXPECT_FALSE(reach.reachable);
    EXPECT_NE(reach.sentence.find("out of reach"), std::string::npos) << reach.sentence;
    // 817 mm = 400 + hypot(410, 75): the data sheet's reach less the 75 mm between axes 1 and 2.
    EXPECT_NE(reach.sentence.find("817 mm"), std::string::npos) << reach.sentence;
}

TEST(InverseKinematics, BeyondARangeItNamesTheJoint) {
    // Over the table behind the arm, the tool looking back at the arm's foot: the wrist centre is
    // within reach but the wrist cannot bend that far.
    SeededRandom random(14);
    int named = 0;
    for (int trial = 0; trial < 500; ++trial) {
        JointAngles q = random_joints(random);
        q[4] = rad_from_deg(random.uniform(125.0, 175.0));
        const Reachability reach = reachability(tool_pose(q), q);
        if (reach.reachable) continue;
        EXPECT_NE(reach.sentence.find("joint"), std::string::npos) << reach.sentence;
        ++named;
    }
    EXPECT_GT(named, 20);
}

}  // namespace
}  // namespace gripscan
