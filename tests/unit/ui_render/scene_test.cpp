// Chunks, picking, lines and the scale bar: what needs no picture.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>

#include "tests/support/random_pose.h"
#include "ui/render/picking.h"
#include "ui/render/primitives.h"
#include "ui/render/scale_bar.h"

namespace gripscan::ui {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;
const Viewport kView{900.0, 578.0};

PointChunk chunk_of(std::vector<Eigen::Vector3f> points) {
    auto cloud = std::make_shared<Cloud>();
    cloud->points = std::move(points);
    PointChunk chunk;
    chunk.id = 3;
    chunk.cloud = cloud;
    return chunk;
}

TEST(PackedPoints, AreThoseOfTheCloudInAnotherOrder) {
    SeededRandom random(1);
    auto cloud = std::make_shared<Cloud>();
    for (int i = 0; i < 5000; ++i) {
        cloud->points.emplace_back(static_cast<float>(i), 0.0F, 0.0F);
        cloud->seen.push_back(static_cast<std::uint16_t>(i));
        cloud->normals.push_back(test::random_direction(random).cast<float>());
    }
    PointChunk chunk = chunk_of({});
    chunk.cloud = cloud;
    chunk.step = 7;
    const auto packed = packed_points(chunk);
    ASSERT_EQ(packed.size(), 5000U);
    std::vector<bool> found(5000, false);
    for (const PackedPoint& p : packed) {
        const auto i = static_cast<std::size_t>(p.x_m);
        EXPECT_FALSE(found[i]);
        found[i] = true;
        EXPECT_EQ(p.seen, i);
        EXPECT_EQ(p.step, 7);
        EXPECT_NEAR(p.nx / 127.0F, cloud->normals[i].x(), 0.005F);
    }
    EXPECT_EQ(0, std::memcmp(packed.data(), packed_points(chunk).data(),
                             packed.size() * sizeof(PackedPoint)))
        << "the same order every time";
}

TEST(PackedPoints, EveryBeginningIsAnEvenSample) {
    std::vector<Eigen::Vector3f> points;
    for (int i = 0; i < 100000; ++i) points.emplace_back(static_cast<float>(i), 0.0F, 0.0F);
    const auto packed = packed_points(chunk_of(points));
    double mean = 0.0;
    for (std::size_t i = 0; i < 2000; ++i) mean += static_cast<double>(packed[i].x_m) / 2000.0;
    // Standard deviation of the mean of 2000 uniform numbers: 1e5 / sqrt(12 · 2000) = 645.
    EXPECT_NEAR(mean, 50000.0, 4.0 * 645.0);
}

TEST(Picking, FindsThePointUnderTheCursorWhereverTheCameraStands) {
    SeededRandom random(2);
    for (int run = 0; run < 50; ++run) {
        std::vector<Eigen::Vector3f> points;
        for (int i = 0; i < 200; ++i) {
            points.push_back(test::random_pose(random, 1.0).translation().cast<float>());
        }
        PointChunk chunk = chunk_of(points);
        chunk.T_world_cloud = test::random_pose(random, 1.0);
        OrbitCamera camera;
        camera.yaw_rad = random.uniform(-3, 3);
        camera.pivot_m = chunk.T_world_cloud * points[17].cast<double>();
        camera.distance_m = 0.4;
        const std::vector chunks{chunk};
        const auto picked = pick_point(chunks, camera, kView, {450, 289}, {.radius_px = 3.0});
        ASSERT_TRUE(picked.has_value());
        if (picked->point != 17) {  // another one stands in front
            EXPECT_LT((camera.T_view_world() * picked->position_m).z(), 0.4);
        } else {
            EXPECT_LT((picked->position_m - camera.pivot_m).norm(), 1e-6);
        }
    }
}

TEST(Picking, PrefersTheFrontSurfaceAndThereTheNearestPixel) {
    const OrbitCamera camera = from_stereo_camera({}, 0.5);
    const auto at = [&](double x_px, double depth) -> Eigen::Vector3f {
        return unproject(camera, kView, {450 + x_px, 289}, depth).cast<float>();
    };
    const std::vector chunks{chunk_of({at(0, 0.6), at(5, 0.5), at(2, 0.501), at(30, 0.3)})};
    const auto picked = pick_point(chunks, camera, kView, {450, 289});
    ASSERT_TRUE(picked.has_value());
    EXPECT_EQ(picked->point, 2U) << "not the hidden one at 0 px, not the one outside the radius";
    EXPECT_NEAR(picked->distance_px, 2.0, 0.01);
}

TEST(Picking, FindsNothingInTheEmptyHiddenOrBehind) {
    const OrbitCamera camera = from_stereo_camera({}, 0.5);
    EXPECT_FALSE(pick_point({}, camera, kView, {450, 289}).has_value());
    std::vector chunks{chunk_of({{0.0F, 0.0F, 0.5F}})};
    EXPECT_TRUE(pick_point(chunks, camera, kView, {450, 289}).has_value());
    EXPECT_FALSE(pick_point(chunks, camera, kView, {480, 289}).has_value());
    chunks[0].visible = false;
    EXPECT_FALSE(pick_point(chunks, camera, kView, {450, 289}).has_value());
    chunks[0] = chunk_of({{0.0F, 0.0F, -0.5F}});
    EXPECT_FALSE(pick_point(chunks, camera, kView, {450, 289}).has_value());
}

TEST(Lines, KeepTheirWidthInPixelsAtAnyDistance) {
    const OrbitCamera camera = from_stereo_camera({}, 0.5);
    LineBatch lines;
    lines.segment({-0.1, 0, 0.3}, {0.1, 0, 0.3}, {.colour = {}, .width_px = 3.0F});
    lines.segment({-0.1, 0, 1.5}, {0.1, 0, 1.5}, {.colour = {}, .width_px = 3.0F});
    const auto vertices = line_vertices(lines, camera, kView, {0.05, 5.0}, 2.0F);
    ASSERT_EQ(vertices.size(), 12U);
    for (const LineVertex& v : vertices) {
        EXPECT_EQ(v.half_width_px, 3.0F);
        EXPECT_NEAR(std::abs(v.y_px - 289.0F), 4.0F, 1e-3F);  // a soft edge of 1 px more
    }
}

TEST(Lines, DashesRunOnThroughTheCorners) {
    const OrbitCamera camera = from_stereo_camera({}, 0.5);
    LineBatch lines;
    const std::array<Vector3d, 3> corner{Vector3d(0, 0, 0.5), Vector3d(0.05, 0, 0.5),
                                         Vector3d(0.05, 0.05, 0.5)};
    lines.polyline(corner, {});
    const auto vertices = line_vertices(lines, camera, kView, {0.05, 5.0}, 1.0F);
    ASSERT_EQ(vertices.size(), 12U);
    EXPECT_EQ(vertices[0].along_px, 0.0F);
    EXPECT_NEAR(vertices[1].along_px, 0.05 * camera.px_per_m(kView), 1e-3);
    EXPECT_EQ(vertices[6].along_px, vertices[1].along_px);
}

TEST(Lines, AreCutAtTheNearPlaneAndNeverFoldOver) {
    const OrbitCamera camera = from_stereo_camera({}, 0.5);
    SeededRandom random(3);
    for (int i = 0; i < 500; ++i) {
        LineBatch lines;
        lines.segment(test::random_pose(random, 1.0).translation(),
                      test::random_pose(random, 1.0).translation(), {});
        for (const LineVertex& v : line_vertices(lines, camera, kView, {0.05, 5.0}, 1.0F)) {
            EXPECT_GE(v.depth, -1e-5F);
            EXPECT_TRUE(std::isfinite(v.x_px) && std::isfinite(v.y_px));
        }
    }
    LineBatch behind;
    behind.segment({0, 0, -1}, {0.1, 0, -2}, {});
    EXPECT_TRUE(line_vertices(behind, camera, kView, {0.05, 5.0}, 1.0F).empty());
}

TEST(Primitives, LieWhereTheyShould) {
    LineBatch lines;
    const Box box{{-1, -2, -3}, {1, 2, 3}};
    add_box(lines, box, Pose::Identity(), {});
    EXPECT_EQ(lines.polylines().size(), 12U);
    double length = 0.0;
    for (const auto& line : lines.polylines()) {
        length += (lines.points()[line.first] - lines.points()[line.first + 1]).norm();
    }
    EXPECT_DOUBLE_EQ(length, 4.0 * (2.0 + 4.0 + 6.0));

    lines.clear();
    SeededRandom random(4);
    const Axis axis{test::random_pose(random, 1.0).translation(), test::random_direction(random)};
    const Vector3d start = test::random_pose(random, 1.0).translation();
    add_arc(lines, axis, start, 0.0, 1.2, {});
    EXPECT_TRUE(lines.points().front().isApprox(start));
    EXPECT_TRUE(lines.points().back().isApprox(turn_about(axis, 1.2) * start, 1e-12));

    lines.clear();
    const Vector3d a(0, 0, 1);
    const Vector3d b(0.3, 0, 1);
    add_capsule(lines, a, b, 0.05, Vector3d::Zero(), {});
    for (const Vector3d& p : lines.points()) {
        const Vector3d nearest = a + std::clamp((p - a).x() / 0.3, 0.0, 1.0) * (b - a);
        EXPECT_NEAR((p - nearest).norm(), 0.05, 1e-12) << "on the capsule's surface";
    }
    lines.clear();
    add_box(lines, Box{}, Pose::Identity(), {});
    EXPECT_TRUE(lines.points().empty()) << "an invalid box has no edges";
}

TEST(ScaleBar, IsRoundAndFits) {
    SeededRandom random(5);
    for (int i = 0; i < 1000; ++i) {
        const double px_per_m = std::pow(10.0, random.uniform(0.0, 6.0));
        const ScaleBar bar = scale_bar(px_per_m, 140.0);
        EXPECT_LE(bar.length_px, 140.0 * (1.0 + 1e-9));
        EXPECT_GT(bar.length_px, 0.39 * 140.0);
        EXPECT_NEAR(bar.length_px, bar.length_mm * px_per_m / 1000.0, 1e-6);
        const double lead =
            bar.length_mm / std::pow(10.0, std::floor(std::log10(bar.length_mm) + 1e-9));
        EXPECT_THAT(lead, testing::AnyOf(testing::DoubleNear(1, 1e-6), testing::DoubleNear(2, 1e-6),
                                         testing::DoubleNear(5, 1e-6)));
    }
    EXPECT_EQ(scale_bar(0.0, 140.0).length_mm, 0.0);
}

}  // namespace
}  // namespace gripscan::ui
