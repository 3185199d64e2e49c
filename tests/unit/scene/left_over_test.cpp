// Things in the way: told apart, measured, and not made of what is known.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <numeric>

#include "core/base/seeded_random.h"
#include "core/scene/left_over.h"

namespace gripscan {
namespace {

/// The side of a box that a camera sees, 1 mm apart, with noise.
void add_plate(Cloud& cloud, const Eigen::Vector3d& corner_m, double width_m, double height_m,
               SeededRandom& random) {
    for (double x = 0.0; x < width_m; x += 0.001) {
        for (double y = 0.0; y < height_m; y += 0.001) {
            const Eigen::Vector3d p = corner_m + Eigen::Vector3d(x, y, 0.0002 * random.normal());
            cloud.points.push_back(p.cast<float>());
        }
    }
}

std::vector<std::size_t> all_of(const Cloud& cloud) {
    std::vector<std::size_t> indices(cloud.size());
    std::iota(indices.begin(), indices.end(), std::size_t{0});
    return indices;
}

TEST(LeftOver, TellsThingsApartWithPlaceAndSize) {
    SeededRandom random(1);
    Cloud scene;
    add_plate(scene, {0.10, 0.05, 0.70}, 0.150, 0.026, random);
    add_plate(scene, {-0.10, 0.00, 0.60}, 0.040, 0.080, random);
    // Lonely flying points are no thing.
    for (int i = 0; i < 200; ++i) {
        scene.points.emplace_back(static_cast<float>(random.uniform(-0.3, -0.15)),
                                  static_cast<float>(random.uniform(-0.3, 0.3)),
                                  static_cast<float>(random.uniform(0.4, 1.0)));
    }
    const auto things = find_left_overs(scene, all_of(scene), {});
    ASSERT_EQ(things.size(), 2U);
    EXPECT_NEAR((things[0].centre_m - Eigen::Vector3d(0.1745, 0.0625, 0.70)).norm(), 0.0, 0.0005);
    // A hundredth is cut off on either side.
    EXPECT_NEAR(things[0].size_m.x(), 0.149, 0.004);
    EXPECT_NEAR(things[0].size_m.y(), 0.025, 0.002);
    EXPECT_LT(things[0].size_m.z(), 0.0015);
    EXPECT_NEAR(things[1].size_m.x(), 0.079, 0.003);
    EXPECT_THAT(sentence(things[1]), testing::HasSubstr("y 40, z 600 mm"));
}

TEST(LeftOver, KnownThingsAreNotInTheWay) {
    SeededRandom random(2);
    Cloud part;
    add_plate(part, {0.0, 0.0, 0.0}, 0.060, 0.060, random);
    Pose T = Pose::Identity();
    T.linear() = Eigen::AngleAxisd(0.7, Eigen::Vector3d(1, 2, 3).normalized()).toRotationMatrix();
    T.translation() = Eigen::Vector3d(0.05, -0.02, 0.7);
    Cloud scene = transformed(part, T);
    const std::size_t of_part = scene.size();
    add_plate(scene, {-0.15, 0.1, 0.65}, 0.050, 0.050, random);
    const KnownThing known{&part, T, 0.003};
    const auto left = without_known(scene, all_of(scene), {{known}});
    EXPECT_EQ(left.size(), scene.size() - of_part);
    const auto things = find_left_overs(scene, left, {});
    ASSERT_EQ(things.size(), 1U);
    EXPECT_THAT(things[0].points, testing::Each(testing::Ge(of_part)));
}

TEST(LeftOver, SmallPiecesAreNoise) {
    SeededRandom random(3);
    Cloud scene;
    add_plate(scene, {0.0, 0.0, 0.7}, 0.007, 0.007, random);
    EXPECT_TRUE(find_left_overs(scene, all_of(scene), {}).empty());
    EXPECT_TRUE(find_left_overs(scene, {}, {}).empty());
}

}  // namespace
}  // namespace gripscan
