// The room of the arm, against the simulated arm's solids.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/base/seeded_random.h"
#include "core/base/units.h"
#include "core/scene/arm_zone.h"
#include "core/sim/arm_model.h"
#include "core/sim/mesh.h"
#include "tests/support/random_pose.h"

namespace gripscan {
namespace {

JointAngles random_joints(SeededRandom& random) {
    JointAngles joints{};
    for (std::size_t i = 0; i < 6; ++i) {
        joints[i] = random.uniform(joint_ranges()[i].min_rad, joint_ranges()[i].max_rad);
    }
    return joints;
}

TEST(ArmZone, HoldsEveryCornerOfTheArm) {
    SeededRandom random(3);
    const auto arm = sim::make_arm();
    for (int round = 0; round < 20; ++round) {
        const JointAngles joints = random_joints(random);
        const Pose T_robot_camera = test::random_pose(random, 3.0);
        const ArmZone zone(joints, T_robot_camera, 0.001);
        const auto T_robot_link = link_poses(joints);
        for (std::size_t link = 0; link < arm.size(); ++link) {
            for (const sim::Part& part : arm[link]) {
                for (const Eigen::Vector3d& v : part.mesh.vertices) {
                    const Eigen::Vector3d p = T_robot_camera.inverse() * T_robot_link[link] * v;
                    ASSERT_TRUE(zone.contains(p)) << part.name << " at " << v.transpose();
                }
            }
        }
    }
}

TEST(ArmZone, LeavesTheToolAlone) {
    SeededRandom random(4);
    for (int round = 0; round < 20; ++round) {
        // A straight wrist: nothing of the arm but the last links is near the flange.
        JointAngles joints{};
        joints[0] = random.uniform(-1.0, 1.0);
        joints[5] = random.uniform(-3.0, 3.0);
        const Pose T_robot_camera = test::random_pose(random, 3.0);
        const ArmZone zone(joints, T_robot_camera);
        const Pose T_camera_tool = T_robot_camera.inverse() * tool_pose(joints);
        for (const double out_m : {0.004, 0.020, 0.050, 0.100}) {
            EXPECT_FALSE(zone.contains(T_camera_tool * Eigen::Vector3d(0, 0, out_m))) << out_m;
            EXPECT_FALSE(zone.contains(T_camera_tool * Eigen::Vector3d(0.05, 0, out_m))) << out_m;
        }
        EXPECT_TRUE(zone.contains(T_camera_tool * Eigen::Vector3d(0.0, 0.02, -0.003)));
    }
}

TEST(ArmZone, TakesTheArmOutOfACloud) {
    const JointAngles joints{};
    const ArmZone zone(joints, Pose::Identity());
    Cloud scene;
    scene.points = {{0.2F, 0.0F, 0.4F}, {0.0F, 0.0F, 0.2F}, {0.5F, 0.5F, 0.5F}, {0.7F, 0.0F, 0.5F}};
    EXPECT_THAT(zone.outside(scene, {0, 1, 2, 3}), testing::ElementsAre(2, 3));
    EXPECT_EQ(zone.capsules().size(), 10U);
}

}  // namespace
}  // namespace gripscan
