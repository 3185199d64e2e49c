// How far a view lies from the others, on surfaces whose distance is known.
#include "core/registration/view_distance.h"

#include <gtest/gtest.h>

#include "tests/support/random_pose.h"

namespace gripscan {
namespace {

/// A plate of 40 × 40 mm at z, a point every mm, seen from −z.
Cloud plate(double z_m) {
    Cloud cloud;
    for (int y = 0; y < 40; ++y) {
        for (int x = 0; x < 40; ++x) {
            cloud.points.emplace_back(0.001F * static_cast<float>(x),
                                      0.001F * static_cast<float>(y), static_cast<float>(z_m));
            cloud.normals.emplace_back(0.0F, 0.0F, -1.0F);
        }
    }
    return cloud;
}

TEST(DistancesToOtherViews, AreThoseBetweenTheSurfaces) {
    for (const std::uint64_t seed : {1, 2, 3}) {
        SeededRandom random(seed);
        const Pose T = test::random_pose(random, 3.0);
        const Cloud near = plate(0.7);
        const Cloud far = plate(0.7 + 0.4e-3);
        const Cloud moved = transformed(far, T.inverse());
        const std::vector<PosedView> views{{&near, Pose::Identity()}, {&moved, T}};
        const auto d = distances_to_other_views(views, 1, for_each_in_order);
        ASSERT_EQ(d.size(), 2U);
        // Points are floats some tenths of a metre from the origin: 1e-7 m each way.
        for (const float own : d[0]) EXPECT_NEAR(own, 0.4e-3, 2e-6);
        for (const float own : d[1]) EXPECT_NEAR(own, 0.4e-3, 2e-6);
    }
}

TEST(DistancesToOtherViews, SayWhereNoOtherViewHasLooked) {
    const Cloud one = plate(0.7);
    Cloud two = plate(0.7);
    for (auto& p : two.points) p.x() += 0.020F;
    const std::vector<PosedView> views{{&one, Pose::Identity()}, {&two, Pose::Identity()}};
    const auto d = distances_to_other_views(views, 1, for_each_in_order);
    for (std::size_t i = 0; i < one.size(); ++i) {
        if (one.points[i].x() > 0.0152F) {
            EXPECT_NEAR(d[0][i], 0.0, 1e-6);
        } else if (one.points[i].x() < 0.0148F) {
            EXPECT_EQ(d[0][i], kNotSeenAgain);
        }
    }
}

TEST(DistancesToOtherViews, TheLastViewLiesBesideTheFirst) {
    std::vector<Cloud> plates;
    for (int k = 0; k < 5; ++k) plates.push_back(plate(0.7 + 0.001 * k));
    std::vector<PosedView> views;
    for (const Cloud& p : plates) views.push_back({&p, Pose::Identity()});
    const auto d = distances_to_other_views(views, 1, for_each_in_order);
    EXPECT_NEAR(d[2][0], 0.001, 1e-6);
    EXPECT_NEAR(d[0][0], 0.001, 1e-6);
    EXPECT_NEAR(d[4][0], 0.001, 1e-6);
}

}  // namespace
}  // namespace gripscan
