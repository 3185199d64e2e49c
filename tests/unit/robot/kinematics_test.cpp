#include "core/robot/kinematics.h"

#include <gtest/gtest.h>

#include "core/base/seeded_random.h"
#include "core/base/units.h"

namespace gripscan {
namespace {

JointAngles joints_deg(double j1, double j2, double j3, double j4, double j5, double j6) {
    return {rad_from_deg(j1), rad_from_deg(j2), rad_from_deg(j3),
            rad_from_deg(j4), rad_from_deg(j5), rad_from_deg(j6)};
}

struct Golden {
    JointAngles joints_rad;
    Eigen::Vector3d xyz_mm;
    Eigen::Vector3d wpr_deg;
};

// Computed from the published chain by other means (the closed-form OPW parameters of the arm).
const std::vector<Golden>& golden_poses() {
    static const std::vector<Golden> poses = {
        {joints_deg(0, 0, 0, 0, 0, 0), {565, 0, 475}, {180, -90, 0}},
        {joints_deg(0, 0, 0, 0, -90, 0), {485, 0, 395}, {180, 0, 0}},
        {joints_deg(0, 0, 0, 0, -90, 30), {485, 0, 395}, {180, 0, 30}},
        {joints_deg(30, 20, -10, 40, -50, 60),
         {600.879, 301.432, 323.380},
         {137.981, 21.855, 99.615}},
        {joints_deg(0, 20, 0, 0, 0, 0), {701.808, 0, 450.877}, {180, -90, 0}},
        {joints_deg(0, 0, 20, 0, 0, 0), {509.798, 0, 638.067}, {0, -70, 180}},
    };
    return poses;
}

TEST(Kinematics, AgreesWithTheGoldenTable) {
    for (const Golden& golden : golden_poses()) {
        const Pose T = tool_pose(golden.joints_rad);
        // The table is rounded to a µm and to a thousandth of a degree.
        EXPECT_LT((T.translation() * kMmPerM - golden.xyz_mm).norm(), 0.001);
        const Eigen::Matrix3d R =
            rotation_from_euler({rad_from_deg(golden.wpr_deg.x()), rad_from_deg(golden.wpr_deg.y()),
                                 rad_from_deg(golden.wpr_deg.z())});
        EXPECT_LT(deg_from_rad(rotation_angle_rad(R.transpose() * T.linear())), 0.001);
    }
}

TEST(Kinematics, WprOfAPoseNamesTheSameRotation) {
    for (const Golden& golden : golden_poses()) {
        const Eigen::Matrix3d R = tool_pose(golden.joints_rad).linear();
        const Eigen::Matrix3d again = rotation_from_euler(euler_from_rotation(R));
        EXPECT_LT(rotation_angle_rad(R.transpose() * again), 1e-7);
    }
}

TEST(Kinematics, TurningOneJointIsATurnAboutItsAxis) {
    SeededRandom random(7);
    for (int trial = 0; trial < 20; ++trial) {
        JointAngles q{};
        for (double& angle : q) angle = random.uniform(-1.5, 1.5);
        for (std::size_t number = 1; number <= 6; ++number) {
            const double turn_rad = random.uniform(-0.5, 0.5);
            JointAngles turned = q;
            turned[number - 1] += turn_rad;
            // J3 is measured against the horizontal: turning joint 2 alone changes it too.
            if (number == 2) turned[2] -= turn_rad;
            const Pose expected = turn_about(joint_axis(q, number), turn_rad) * tool_pose(q);
            EXPECT_LT((tool_pose(turned).matrix() - expected.matrix()).norm(), 1e-12)
                << "joint " << number;
        }
    }
}

TEST(Kinematics, WristAxesMeetAndTheFlangeIsEightyMillimetresAway) {
    const JointAngles q = joints_deg(25, -10, 33, 70, -40, 110);
    const Axis axis5 = joint_axis(q, 5);
    EXPECT_LT(joint_axis(q, 4).distance_m(axis5.point_m), 1e-12);
    EXPECT_LT(joint_axis(q, 6).distance_m(axis5.point_m), 1e-12);
    EXPECT_NEAR((tool_pose(q).translation() - axis5.point_m).norm(), 0.080, 1e-12);
}

TEST(Kinematics, SaysWhichJointIsOutOfRange) {
    EXPECT_TRUE(check_joint_ranges(joints_deg(0, 0, 0, 0, 0, 360)));
    const Status last = check_joint_ranges(joints_deg(0, 0, 0, 0, 0, 361));
    ASSERT_FALSE(last);
    EXPECT_NE(last.error().message.find("joint 6"), std::string::npos);
    // J2 + J3 = 140 + 100 deg: each alone would do.
    const Status elbow = check_joint_ranges(joints_deg(0, 140, 100, 0, 0, 0));
    ASSERT_FALSE(elbow);
    EXPECT_NE(elbow.error().message.find("joint 3"), std::string::npos);
    EXPECT_FALSE(check_joint_ranges(joints_deg(std::nan(""), 0, 0, 0, 0, 0)));
}

}  // namespace
}  // namespace gripscan
