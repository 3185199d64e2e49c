// What the cell check measures, on shapes whose answer is known: boxes before a camera, walls,
// turned plates.
#include <gmock/gmock.h>

#include "core/base/seeded_random.h"
#include "core/base/units.h"
#include "core/procedure/region_view.h"
#include "core/procedure/still_surface.h"
#include "core/procedure/surface_pieces.h"
#include "core/procedure/swept_room.h"

namespace gripscan::test {
namespace {

using testing::HasSubstr;

/// A plate of 1 mm grid in the plane through `corner`, with noise of a stereo camera.
void add_plate(Cloud& cloud, const Eigen::Vector3d& corner_m, const Eigen::Vector3d& a_m,
               const Eigen::Vector3d& b_m, std::uint64_t seed = 1) {
    SeededRandom random(seed);
    const int n = static_cast<int>(a_m.norm() / 0.001);
    const int m = static_cast<int>(b_m.norm() / 0.001);
    const Eigen::Vector3d normal = a_m.cross(b_m).normalized();
    for (int i = 0; i < n; ++i) {
        for (int j = 0; j < m; ++j) {
            const Eigen::Vector3d p =
                corner_m + a_m * i / n + b_m * j / m + normal * random.normal() * 0.0002;
            cloud.points.push_back(p.cast<float>());
        }
    }
}

RectifiedRig rig() {
    return {{1280, 960}, 1000.0, 640.0, 640.0, 480.0, 0.12};
}

TEST(RegionInView, NamesTheCornerNearestABorderAndTheErrorOfTheFarSide) {
    // At 0.6 m a corner 0.2 m to the left is 640 − 333 = 307 px from the left image's border, and
    // 200 px less from the right image's.
    const Box region{{-0.2, -0.1, 0.6}, {0.1, 0.1, 1.0}};
    const VolumeFacts facts = region_in_view(region, rig());
    EXPECT_NEAR(facts.margin_px, 640.0 - 0.2 / 0.6 * 1000.0 - 200.0, 1e-6);
    EXPECT_THAT(facts.nearest, HasSubstr("right image"));
    EXPECT_TRUE(facts.can_be_matched);
    EXPECT_NEAR(facts.far_disparity_px, 120.0, 1e-9);
    EXPECT_NEAR(facts.far_sd_m, 1.0 / 120.0 * 0.2, 1e-12);  // Z² / (f B) · 0.2 px
}

TEST(RegionInView, SaysWhereARegionCannotBeSeen) {
    EXPECT_LT(region_in_view({{-0.5, -0.1, 0.6}, {0.1, 0.1, 1.0}}, rig()).margin_px, 0.0);
    EXPECT_LT(region_in_view({{-0.1, -0.1, -0.1}, {0.1, 0.1, 1.0}}, rig()).margin_px, 0.0);
    EXPECT_FALSE(region_in_view({{-0.1, -0.1, -0.3}, {0.1, 0.1, -0.1}}, rig()).can_be_matched);
}

TEST(SurfacePieces, AreToldApartByTheirGapTheLargestFirst) {
    Cloud cloud;
    add_plate(cloud, {0, 0, 0.7}, {0.02, 0, 0}, {0, 0.02, 0});
    add_plate(cloud, {0.03, 0, 0.7}, {0.04, 0, 0}, {0, 0.02, 0});  // 10 mm beside it
    cloud.points.push_back({0.5F, 0.5F, 0.5F});                    // a chance match
    const auto apart = pieces_of(cloud, 0.008, 30e-6);
    ASSERT_EQ(apart.size(), 2U);
    // Counted in cubes of 2 mm: the noise spreads the plates at z = 0.7 over two layers of them.
    EXPECT_THAT(apart[0].area_m2, testing::AllOf(testing::Gt(720e-6), testing::Lt(1600e-6)));
    EXPECT_NEAR(apart[0].centre_m.x(), 0.05, 0.001);
    EXPECT_THAT(apart[1].area_m2, testing::AllOf(testing::Gt(360e-6), testing::Lt(800e-6)));
    EXPECT_EQ(pieces_of(cloud, 0.015, 30e-6).size(), 1U);
    EXPECT_TRUE(pieces_of(Cloud{}, 0.008, 30e-6).empty());
}

/// A gripper about the x axis at z = 0.7: two plates 40 mm long, 60 mm across.
Cloud gripper(double turn_rad, std::uint64_t seed) {
    Cloud cloud;
    add_plate(cloud, {-0.04, -0.03, 0.69}, {0.04, 0, 0}, {0, 0.06, 0}, seed);
    add_plate(cloud, {-0.04, -0.03, 0.66}, {0.04, 0, 0}, {0, 0, 0.03}, seed + 1);
    return transformed(cloud, turn_about({{0, 0, 0.7}, {1, 0, 0}}, turn_rad));
}

double area_mm2(const Cloud& cloud) {
    double sum = 0.0;
    for (const Piece& piece : pieces_of(cloud, 0.008, 30e-6)) sum += 1e6 * piece.area_m2;
    return sum;
}

TEST(StillSurface, IsEmptyForAGripperThatTurnsAndHoldsWhatDoesNotTurnWithIt) {
    const Axis axis{{0, 0, 0.7}, {1, 0, 0}};
    const double turn_rad = rad_from_deg(12.0);
    for (const std::uint64_t seed : {11U, 22U, 33U}) {
        Cloud first = gripper(0.0, seed);
        Cloud second = gripper(turn_rad, seed + 100);
        const StillSurface none = still_surface(first, second, axis, turn_rad);
        EXPECT_EQ(area_mm2(none.beside), 0.0);
        EXPECT_EQ(area_mm2(none.at_arm), 0.0);
        for (Cloud* cloud : {&first, &second}) {
            const std::uint64_t noise = seed + (cloud == &first ? 1 : 2);
            add_plate(*cloud, {-0.03, 0.05, 0.64}, {0.02, 0, 0}, {0, 0.02, 0}, noise);  // a thing
            add_plate(*cloud, {0.03, -0.02, 0.66}, {0.03, 0, 0}, {0, 0.04, 0}, noise);  // the wrist
        }
        const StillSurface both = still_surface(first, second, axis, turn_rad);
        EXPECT_GT(area_mm2(both.beside), 200.0);  // of 400: the rest looks turned as well
        EXPECT_GT(area_mm2(both.at_arm), 300.0);  // of 1200
        EXPECT_LT(area_mm2(both.beside), 800.0);
    }
}

TEST(SweptRoom, IsTheDistanceFromTheGrippersRadiusToWhatStandsBesideIt) {
    const Axis axis{{0, 0, 0.7}, {1, 0, 0}};
    const Box region{{-0.06, -0.05, 0.62}, {0.02, 0.05, 0.78}};
    Cloud part;
    add_plate(part, {-0.04, -0.03, 0.7}, {0.04, 0, 0}, {0, 0.06, 0});
    Cloud scene = part;
    EXPECT_GT(swept_room(part, scene, region, axis).free_radius_m, 1.0);
    add_plate(scene, {-0.05, 0.07, 0.65}, {0.06, 0, 0}, {0, 0, 0.1});  // a wall 70 mm beside
    add_plate(scene, {0.05, 0.05, 0.65}, {0.06, 0, 0}, {0, 0, 0.1});   // the arm: does not count
    const SweepFacts facts = swept_room(part, scene, region, axis);
    EXPECT_NEAR(facts.gripper_radius_m, 0.030, 0.001);
    EXPECT_NEAR(facts.free_radius_m, 0.070, 0.001);
}

}  // namespace
}  // namespace gripscan::test
