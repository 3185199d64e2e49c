// Through a wall of the registration area that does not cut the part, the part cannot leave it.
#include "core/registration/region_walls.h"

#include <gtest/gtest.h>

#include <vector>

namespace gripscan {
namespace {

const Box kRegion{{-0.1, -0.1, 0.5}, {0.1, 0.1, 0.7}};
constexpr float kMargin_m = 0.005F;

/// A part in the middle and, if asked for, points along the wall at x = 0.1.
std::vector<Eigen::Vector3f> part(bool cut) {
    std::vector<Eigen::Vector3f> points;
    for (int i = 0; i < 50; ++i) {
        const float s = 0.001F * static_cast<float>(i);
        points.emplace_back(s, -s, 0.6F);
        if (cut) points.emplace_back(0.098F, s, 0.6F);
    }
    return points;
}

TEST(RegionWalls, OutsideIsOutsideTheMargin) {
    const RegionWalls walls(kRegion, part(false), kMargin_m);
    EXPECT_TRUE(walls.leaves({0.12F, 0.0F, 0.6F}));
    EXPECT_TRUE(walls.leaves({0.0F, 0.0F, 0.49F}));
    EXPECT_FALSE(walls.leaves({0.103F, 0.0F, 0.6F})) << "within the margin";
    EXPECT_FALSE(walls.leaves({0.0F, 0.0F, 0.6F}));
}

TEST(RegionWalls, AWallThatCutsThePartProvesNothing) {
    const RegionWalls walls(kRegion, part(true), kMargin_m);
    EXPECT_FALSE(walls.leaves({0.12F, 0.0F, 0.6F}));
    EXPECT_FALSE(walls.leaves({0.12F, 0.12F, 0.6F})) << "the part may go on beyond that wall";
    EXPECT_TRUE(walls.leaves({0.0F, 0.12F, 0.6F})) << "the other walls still hold";
}

TEST(RegionWalls, AFewStrayPointsDoNotCut) {
    auto points = part(false);
    for (int i = 0; i < 5; ++i) points.emplace_back(0.099F, 0.0F, 0.6F);
    EXPECT_TRUE(RegionWalls(kRegion, points, kMargin_m).leaves({0.12F, 0.0F, 0.6F}));
}

TEST(RegionWalls, DeepInsideKeepsAwayFromAllWalls) {
    const RegionWalls walls(kRegion, part(false), kMargin_m);
    EXPECT_TRUE(walls.deep_inside({0.0F, 0.09F, 0.6F}));
    EXPECT_FALSE(walls.deep_inside({0.0F, 0.097F, 0.6F}));
    EXPECT_FALSE(walls.deep_inside({0.0F, 0.2F, 0.6F}));
}

}  // namespace
}  // namespace gripscan
