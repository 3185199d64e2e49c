// What a camera sees of a template: nothing that faces away, and nothing behind a part of it.
#include "core/scene/template_front.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace gripscan {
namespace {

/// A square of points every millimetre, its normal along z (towards the camera: −1).
void add_plate(Cloud& cloud, float half_m, float z_m, float towards) {
    for (float x = -half_m; x <= half_m; x += 0.001F) {
        for (float y = -half_m; y <= half_m; y += 0.001F) {
            cloud.points.emplace_back(x, y, z_m);
            cloud.normals.emplace_back(0.0F, 0.0F, towards);
        }
    }
}

TEST(TemplateFront, LeavesOutWhatFacesAway) {
    Cloud cloud;
    add_plate(cloud, 0.02F, 0.0F, -1.0F);
    const std::size_t facing = cloud.size();
    add_plate(cloud, 0.02F, 0.004F, 1.0F);
    Pose T = Pose::Identity();
    T.translation().z() = 0.6;
    EXPECT_EQ(template_front(cloud, T, Eigen::Vector3f::Zero()).size(), facing);
}

TEST(TemplateFront, LeavesOutWhatItHidesItself) {
    Cloud cloud;
    add_plate(cloud, 0.010F, 0.0F, -1.0F);
    const std::size_t before = cloud.size();
    add_plate(cloud, 0.020F, 0.030F, -1.0F);
    Pose T = Pose::Identity();
    T.translation().z() = 0.6;
    const Cloud front = template_front(cloud, T, Eigen::Vector3f::Zero());
    EXPECT_FALSE(front.viewpoint);
    std::size_t behind = 0;
    for (const auto& p : front.points) {
        if (p.z() < 0.61F) continue;
        ++behind;
        // Seen past the small plate, but for the cell at its edge.
        EXPECT_GT(std::max(std::abs(p.x()), std::abs(p.y())), 0.0105F * 0.63F / 0.6F - 0.003F);
    }
    EXPECT_EQ(front.size() - behind, before);
    // 41² points, of which the plate before hides some 21² (nearer: a twentieth larger).
    EXPECT_NEAR(static_cast<double>(behind), 41.0 * 41.0 - 22.0 * 22.0, 150.0);
}

}  // namespace
}  // namespace gripscan
