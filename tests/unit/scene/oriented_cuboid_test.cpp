#include "core/scene/oriented_cuboid.h"

#include <gtest/gtest.h>

#include <vector>

#include "core/base/seeded_random.h"
#include "core/scene/held_pose.h"

namespace gripscan {
namespace {

Eigen::Vector3d kHalf() {
    return {0.060, 0.035, 0.020};
}

/// Points in a box of that size which stands at T; its corners among them.
std::vector<Eigen::Vector3f> box_at(const Pose& T, SeededRandom& random) {
    std::vector<Eigen::Vector3f> points;
    for (const auto& corner : OrientedCuboid{T, kHalf()}.corners_m()) {
        points.push_back(corner.cast<float>());
    }
    for (int i = 0; i < 300; ++i) {
        const Eigen::Vector3d local(random.uniform(-1, 1), random.uniform(-1, 1),
                                    random.uniform(-1, 1));
        points.push_back((T * local.cwiseProduct(kHalf())).cast<float>());
    }
    return points;
}

Pose pose_of(SeededRandom& random) {
    const auto v = [&](double size) {
        return Eigen::Vector3d(random.uniform(-size, size), random.uniform(-size, size),
                               random.uniform(-size, size));
    };
    Pose T = Pose::Identity();
    T.linear() = rotation_from_vector(v(1.7));
    T.translation() = v(0.8);
    return T;
}

TEST(OrientedCuboid, AlongAnAxisItIsTheBoxToADegree) {
    SeededRandom random(3);
    for (int i = 0; i < 20; ++i) {
        const Pose T = pose_of(random);
        const auto points = box_at(T, random);
        const OrientedCuboid cuboid = cuboid_along(points, T.linear().col(2));
        for (const auto& p : points) {
            EXPECT_TRUE(
                widened(cuboid, {Eigen::Vector3d::Constant(1e-6), Eigen::Vector3d::Constant(1e-6)})
                    .contains(p.cast<double>()));
        }
        // Half a degree off adds no more than 0.0087 of the other side.
        EXPECT_NEAR(cuboid.half_m.x(), kHalf().x(), 0.0088 * kHalf().y());
        EXPECT_NEAR(cuboid.half_m.y(), kHalf().y(), 0.0088 * kHalf().x());
        EXPECT_NEAR(cuboid.half_m.z(), kHalf().z(), 1e-6);
    }
}

TEST(OrientedCuboid, AroundPointsItIsHardlyLargerThanTheirBox) {
    SeededRandom random(5);
    for (int i = 0; i < 20; ++i) {
        const Pose T = pose_of(random);
        const auto points = box_at(T, random);
        // The principal axes of 300 random points are off by some degrees.
        EXPECT_LT(cuboid_around(points).volume_m3(), 1.5 * 8.0 * kHalf().prod());
    }
}

TEST(OrientedCuboid, EveryFaceHasItsOwnMargin) {
    const OrientedCuboid cuboid{Pose::Identity(), kHalf()};
    FaceMargins margins;
    margins.high_m.x() = 0.010;
    margins.low_m.z() = -0.005;
    const OrientedCuboid wide = widened(cuboid, margins);
    EXPECT_TRUE(wide.contains({0.069, 0.0, 0.0}));
    EXPECT_FALSE(wide.contains({-0.061, 0.0, 0.0}));
    EXPECT_FALSE(wide.contains({0.0, 0.0, -0.016}));
    EXPECT_TRUE(wide.contains({0.0, 0.0, 0.019}));
    margins.low_m.y() = -0.200;
    EXPECT_EQ(widened(cuboid, margins).half_m.y(), 0.0) << "a face stops at the opposite one";
}

TEST(HeldPose, IsTheMeanOfTheCaptures) {
    SeededRandom random(9);
    const Pose truth = pose_of(random);
    const Eigen::Vector3d centre(0.1, -0.2, 0.7);
    std::vector<HeldView> views;
    for (int k = 0; k < 36; ++k) {
        const Pose T_camera_gripper = pose_of(random);
        Vector6d noise;
        for (int i = 0; i < 6; ++i) noise(i) = random.normal() * (i < 3 ? 1e-3 : 1e-4);
        const Pose in_gripper = motion_about(noise, truth * centre) * truth;
        views.push_back({T_camera_gripper, T_camera_gripper * in_gripper});
    }
    const auto held = held_pose(views, centre);
    ASSERT_TRUE(held);
    EXPECT_EQ(held->captures, 36u);
    const Pose error = held->T_gripper_object * truth.inverse();
    // √3 · 1e-3 / √36 and √3 · 1e-4 / √36, four times.
    EXPECT_LT(rotation_angle_rad(error.linear()), 1.2e-3);
    EXPECT_LT((held->T_gripper_object * centre - truth * centre).norm(), 1.2e-4);
    EXPECT_NEAR(held->sd_rad, 2.9e-4, 1.0e-4);
    EXPECT_NEAR(held->sd_m, 2.9e-5, 1.0e-5);
    EXPECT_FALSE(held_pose({}, centre));
}

}  // namespace
}  // namespace gripscan
