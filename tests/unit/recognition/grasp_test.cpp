#include "core/recognition/grasp.h"

#include <gtest/gtest.h>

#include <vector>

#include "core/base/units.h"
#include "tests/support/pose_matchers.h"
#include "tests/support/random_pose.h"

namespace gripscan {
namespace {

constexpr JointAngles kJoints{0.2, 0.3, -0.4, 0.5, -0.9, 0.7};

TEST(Grasp, RepeatsThePoseInWhichTheObjectWasHeld) {
    SeededRandom random(5);
    for (int trial = 0; trial < 100; ++trial) {
        // The cell as it was at registration: everything follows from these three.
        const Pose T_robot_camera = test::random_pose(random, 3.1);
        const Pose T_camera_gripper = Pose::Identity();  // the template's frame is that camera's
        const Pose T_camera_object = test::random_pose(random, 3.1);
        Grasp grasp;
        grasp.T_gripper_object = T_camera_gripper.inverse() * T_camera_object;
        grasp.T_tool_gripper = T_tool_template(T_robot_camera, kJoints);
        // The object where it was: the arm must go where it was.
        const GraspPose again = grasp_pose(T_robot_camera * T_camera_object, grasp, kJoints);
        EXPECT_LT((again.T_robot_tool.matrix() - tool_pose(kJoints).matrix()).norm(), 1e-9);
        ASSERT_TRUE(again.reach.reachable) << again.reach.sentence;
        for (std::size_t i = 0; i < 6; ++i) {
            EXPECT_NEAR(again.reach.joints_rad[i], kJoints[i], 1e-6);
        }
    }
}

TEST(Grasp, FollowsTheObject) {
    Grasp grasp;
    grasp.T_tool_gripper.translation() = Eigen::Vector3d(0.0, 0.0, 0.1);
    grasp.T_gripper_object.translation() = Eigen::Vector3d(0.02, 0.0, 0.03);
    Pose object = tool_pose(kJoints) * grasp.T_tool_gripper * grasp.T_gripper_object;
    object.translation() += Eigen::Vector3d(0.03, -0.02, 0.01);
    const GraspPose moved = grasp_pose(object, grasp, kJoints);
    EXPECT_LT((moved.T_robot_tool.translation() - tool_pose(kJoints).translation() -
               Eigen::Vector3d(0.03, -0.02, 0.01))
                  .norm(),
              1e-12);
}

TEST(Grasp, OfASymmetricObjectTheNearestWayIsTaken) {
    const Pose here = tool_pose(kJoints);
    Pose turned = here;
    turned.linear() = here.linear() * Eigen::AngleAxisd(2.0, Eigen::Vector3d::UnitZ()).matrix();
    const std::vector<Pose> same{turned, here};
    const GraspPose best = best_grasp(same, {}, kJoints);
    EXPECT_LT((best.T_robot_tool.matrix() - here.matrix()).norm(), 1e-9);
}

TEST(Grasp, OutOfReachItSaysSo) {
    Pose far = Pose::Identity();
    far.translation() = Eigen::Vector3d(1.6, 0.0, 0.4);
    const GraspPose pose = grasp_pose(far, {}, kJoints);
    EXPECT_FALSE(pose.reach.reachable);
    EXPECT_NE(pose.reach.sentence.find("out of reach"), std::string::npos);
}

TEST(Grasp, FanucsSixNumbersNameTheSamePose) {
    const Pose T = tool_pose({rad_from_deg(30), rad_from_deg(20), rad_from_deg(-10),
                              rad_from_deg(40), rad_from_deg(-50), rad_from_deg(60)});
    const FanucPose f = fanuc_pose(T);
    // The golden table of the arm.
    EXPECT_NEAR(f.x_mm, 600.879, 1e-3);
    EXPECT_NEAR(f.y_mm, 301.432, 1e-3);
    EXPECT_NEAR(f.z_mm, 323.380, 1e-3);
    EXPECT_NEAR(f.w_deg, 137.981, 1e-3);
    EXPECT_NEAR(f.p_deg, 21.855, 1e-3);
    EXPECT_NEAR(f.r_deg, 99.615, 1e-3);
}

}  // namespace
}  // namespace gripscan
