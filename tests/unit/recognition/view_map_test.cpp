#include "core/recognition/view_map.h"

#include <gtest/gtest.h>

namespace gripscan {
namespace {

constexpr int kWidth = 160;
constexpr int kHeight = 12;

/// A wall at 1 m, a post at 0.5 m over columns 60 … 79; nothing is measured in columns 80 … 87,
/// beside the post, nor in columns 120 … 127, in the middle of the wall.
Cloud wall_and_post() {
    Cloud cloud;
    cloud.grid_width = kWidth;
    cloud.grid_height = kHeight;
    cloud.viewpoint = Eigen::Vector3f::Zero();
    for (int cell = 0; cell < kWidth * kHeight; ++cell) {
        const int column = cell % kWidth;
        if ((column >= 80 && column < 88) || (column >= 120 && column < 128)) continue;
        const float depth_m = column >= 60 && column < 80 ? 0.5F : 1.0F;
        const auto x = static_cast<float>(column - kWidth / 2) / 200.0F;
        const auto y = static_cast<float>(cell / kWidth - kHeight / 2) / 200.0F;
        cloud.points.emplace_back(depth_m * x, depth_m * y, depth_m);
        cloud.cell.push_back(cell);
    }
    return cloud;
}

TEST(ViewMap, AGapBesideSomethingNearerIsItsShadow) {
    const ViewMap map(wall_and_post(), Eigen::Vector3f::Zero());
    ASSERT_EQ(map.width(), kWidth);
    for (int row = 0; row < kHeight; ++row) {
        for (int column = 80; column < 88; ++column) {
            EXPECT_TRUE(map.in_shadow(column, row, 0.9F)) << column;
            EXPECT_FALSE(map.in_shadow(column, row, 0.4F)) << "the post is no nearer than that";
        }
        for (int column = 120; column < 128; ++column) {
            EXPECT_FALSE(map.in_shadow(column, row, 0.9F)) << column << ": beside it is the wall";
        }
    }
}

/// A tenth of the image is further than any post throws its shadow.
TEST(ViewMap, AShadowIsNoWiderThanTheBaselineMakesIt) {
    Cloud cloud = wall_and_post();
    Cloud wide;
    wide.grid_width = cloud.grid_width;
    wide.grid_height = cloud.grid_height;
    wide.viewpoint = cloud.viewpoint;
    for (std::size_t i = 0; i < cloud.size(); ++i) {
        const int column = cloud.cell[i] % kWidth;
        if (column >= 80 && column < 110) continue;
        wide.points.push_back(cloud.points[i]);
        wide.cell.push_back(cloud.cell[i]);
    }
    const ViewMap map(wide, Eigen::Vector3f::Zero());
    EXPECT_TRUE(map.in_shadow(81, 5, 0.9F));
    EXPECT_FALSE(map.in_shadow(95, 5, 0.9F));
}

}  // namespace
}  // namespace gripscan
