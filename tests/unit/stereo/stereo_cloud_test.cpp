// The whole chain on rendered scenes of known geometry and on the recordings.
#include "core/stereo/stereo_cloud.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <opencv2/core.hpp>

#include "core/camera/image_file.h"
#include "core/concurrency/worker_pool.h"
#include "core/stereo/calibrate.h"
#include "core/stereo/rectifier.h"
#include "core/stereo/rig_file.h"
#include "tests/support/test_data.h"
#include "tests/unit/stereo/ray_scene.h"

namespace gripscan::test {
namespace {

using testing::AllOf;
using testing::HasSubstr;

/// A textured ball in front of a textured wall that lies outside of the region.
RayScene ball_and_wall() {
    RayScene scene;
    scene.planes.push_back({Eigen::Vector3d(0.1, 0.05, 1.0).normalized(), 1.25});
    scene.spheres.push_back({Eigen::Vector3d(0.01, 0.0, 0.74), 0.06});
    return scene;
}

const Box kRegion{{-0.09, -0.09, 0.64}, {0.11, 0.09, 0.84}};

RectifiedRig scene_rig() {
    RectifiedRig rig = cell_rig(480, 300);
    rig.cx_left_px -= 40.0;
    rig.cx_right_px += 60.0;
    return rig;
}

Result<StereoCloud> cloud_of(const RenderedPair& pair, const std::optional<Box>& region,
                             const StereoSettings& settings = {},
                             const ForEach& for_each = for_each_in_order) {
    return stereo_cloud(pair.frame, scene_rig(), region, settings, Progress{}, for_each);
}

TEST(StereoCloud, HasNoFlyingPixelsAroundABall) {
    const RayScene scene = ball_and_wall();
    const RenderedPair pair = render(scene, scene_rig(), {});
    const auto result = cloud_of(pair, kRegion);
    ASSERT_TRUE(result) << result.error().message;
    const Cloud& cloud = result->cloud;
    const double visible = cv::countNonZero((pair.surface == 1) & (pair.visible_in_both == 1));
    EXPECT_GT(static_cast<double>(cloud.size()), 0.85 * visible);
    const SphereSurface& ball = scene.spheres[0];
    double squares = 0.0, chi = 0.0, off = 0.0, tilt = 0.0;
    for (std::size_t i = 0; i < cloud.size(); ++i) {
        const Eigen::Vector3d p = cloud.points[i].cast<double>();
        const double distance = (p - ball.centre_m).norm() - ball.radius_m;
        squares += distance * distance;
        off = std::max(off, std::abs(distance));
        const Eigen::Vector3d normal = (p - ball.centre_m).normalized();
        tilt += std::acos(std::min(1.0, normal.dot(cloud.normals[i].cast<double>())));
        const double along = distance / std::max(0.3, -normal.dot(p.normalized()));
        chi += std::pow(along / static_cast<double>(cloud.sigma[i]), 2);
    }
    const double n = static_cast<double>(cloud.size());
    // 0.06 px are 0.28 mm along the ray here.
    EXPECT_LT(std::sqrt(squares / n), 0.45e-3);
    EXPECT_LT(off, 6e-3) << "the furthest point from the ball";
    EXPECT_LT(tilt / n, 0.08) << "mean angle to the true normal, rad";
    EXPECT_LT(std::sqrt(chi / n), 1.6) << "error over predicted sigma";
    EXPECT_GT(std::sqrt(chi / n), 0.7);
}

TEST(StereoCloud, KeepsTheImageGridAndWhatIsKnownOfEveryPoint) {
    const RenderedPair pair = render(ball_and_wall(), scene_rig(), {});
    const auto result = cloud_of(pair, kRegion);
    ASSERT_TRUE(result);
    const Cloud& cloud = result->cloud;
    const RectifiedRig rig = scene_rig();
    EXPECT_EQ(cloud.grid_width, rig.image.width);
    EXPECT_EQ(cloud.grid_height, rig.image.height);
    ASSERT_EQ(cloud.normals.size(), cloud.size());
    ASSERT_EQ(cloud.intensity.size(), cloud.size());
    ASSERT_EQ(cloud.sigma.size(), cloud.size());
    ASSERT_EQ(cloud.cell.size(), cloud.size());
    EXPECT_TRUE(std::is_sorted(cloud.cell.begin(), cloud.cell.end()));
    ASSERT_TRUE(cloud.viewpoint);
    EXPECT_EQ(cloud.viewpoint->norm(), 0.0F);
    for (std::size_t i = 0; i < cloud.size(); ++i) {
        const Eigen::Vector2d uv = rig.project(cloud.points[i].cast<double>());
        ASSERT_NEAR(uv.x(), cloud.cell[i] % rig.image.width, 1e-3);
        ASSERT_NEAR(uv.y(), cloud.cell[i] / rig.image.width, 1e-3);
        ASSERT_EQ(cloud.intensity[i], static_cast<float>(pair.frame.left.data[cloud.cell[i]]));
        ASSERT_NEAR(cloud.normals[i].norm(), 1.0F, 1e-5F);
        ASSERT_LT(cloud.normals[i].dot(cloud.points[i]), 0.0F);
        ASSERT_TRUE(kRegion.contains(cloud.points[i].cast<double>()));
        ASSERT_GT(cloud.sigma[i], 0.0F);
    }
}

TEST(StereoCloud, WallBehindTheRegionGivesNoPointsEvenUncropped) {
    const RenderedPair pair = render(ball_and_wall(), scene_rig(), {});
    StereoSettings settings;
    settings.crop_to_region = false;
    const auto result = cloud_of(pair, kRegion, settings);
    ASSERT_TRUE(result);
    std::size_t outside = 0;
    for (const auto& p : result->cloud.points) {
        if (!kRegion.contains(p.cast<double>())) ++outside;
    }
    EXPECT_LT(static_cast<double>(outside), 0.02 * static_cast<double>(result->cloud.size()));
}

TEST(StereoCloud, IsTheSameForAnyNumberOfThreads) {
    const RenderedPair pair = render(ball_and_wall(), scene_rig(), {});
    WorkerPool pool(3);
    const auto one = cloud_of(pair, kRegion);
    const auto three = cloud_of(pair, kRegion, {}, pool.for_each());
    ASSERT_TRUE(one && three);
    EXPECT_EQ(one->cloud.points, three->cloud.points);
    EXPECT_EQ(one->cloud.normals, three->cloud.normals);
    EXPECT_EQ(one->cloud.sigma, three->cloud.sigma);
    EXPECT_EQ(one->cloud.cell, three->cloud.cell);
    EXPECT_EQ(cv::norm(one->disparity != three->disparity, cv::NORM_INF), 0.0);
}

TEST(StereoCloud, HealthTellsRowsThatDoNotMatch) {
    const RectifiedRig rig = scene_rig();
    RenderedPair pair = render(ball_and_wall(), rig, {});
    StereoSettings settings;
    settings.min_disparity = -16;
    settings.num_disparities = 112;
    const auto good = cloud_of(pair, std::nullopt, settings);
    ASSERT_TRUE(good);
    EXPECT_LT(std::abs(good->health.row_error_px), 0.05);
    EXPECT_GT(good->health.fill, 0.6);
    EXPECT_GT(good->health.texture, 5.0);
    EXPECT_EQ(good->health.saturated, 0.0);
    // The same scene through a camera whose rows lie one lower.
    cv::Mat shifted = pair.frame.right.clone();
    pair.frame.right.rowRange(0, rig.image.height - 1)
        .copyTo(shifted.rowRange(1, rig.image.height));
    pair.frame.right = shifted;
    const auto bad = cloud_of(pair, std::nullopt, settings);
    ASSERT_TRUE(bad);
    EXPECT_NEAR(bad->health.row_error_px, 1.0, 0.35);
}

TEST(StereoCloud, SaysWhatIsWrongWithItsInput) {
    const RectifiedRig rig = scene_rig();
    const RenderedPair pair = render(ball_and_wall(), rig, {});
    const auto message = [&](const StereoFrame& frame, const Box& region, StereoSettings s = {}) {
        const auto r = stereo_cloud(frame, rig, region, s, Progress{}, for_each_in_order);
        return r ? std::string("no error") : r.error().message;
    };
    StereoFrame small = pair.frame;
    small.left = small.left.colRange(0, 100).clone();
    EXPECT_THAT(message(small, kRegion), HasSubstr("left image is 100 x 300"));
    EXPECT_THAT(message(pair.frame, Box{{0, 0, 0.7}, {0.1, 0.1, 0.7}}), HasSubstr("is empty"));
    EXPECT_THAT(message(pair.frame, Box{{-1, -1, -2}, {1, 1, -1}}), HasSubstr("behind"));
    EXPECT_THAT(message(pair.frame, Box{{3, 3, 0.7}, {3.1, 3.1, 0.8}}), HasSubstr("outside"));
    EXPECT_THAT(message(pair.frame, Box{{-0.1, -0.1, 1e-6}, {0.1, 0.1, 1e6}}),
                AllOf(HasSubstr("the region, z 1e-06"), HasSubstr("comes too near the cameras")));
    StereoSettings settings;
    settings.num_disparities = -5;
    EXPECT_THAT(message(pair.frame, kRegion, settings), HasSubstr("make no sense"));
    std::stop_source stop;
    stop.request_stop();
    const auto cancelled = stereo_cloud(pair.frame, rig, kRegion, {},
                                        Progress{stop.get_token(), {}}, for_each_in_order);
    ASSERT_FALSE(cancelled);
    EXPECT_EQ(cancelled.error().kind, ErrorKind::kCancelled);
}

Result<StereoCloud> recorded(const std::filesystem::path& folder, const StereoRig& rig,
                             const std::string& left, const std::string& right,
                             const std::optional<Box>& region, const StereoSettings& settings) {
    const auto rectifier = Rectifier::create(rig);
    const auto l = load_grey_image(folder / left);
    const auto r = load_grey_image(folder / right);
    if (!rectifier || !l || !r)
        return input_error("cannot read the recording in {}", folder.string());
    const auto frame = rectifier->rectify({*l, *r, 0.0});
    if (!frame) return forward_error(frame.error());
    return stereo_cloud(*frame, rectifier->rig(), region, settings, Progress{}, for_each_in_order);
}

TEST(StereoCloudRecordings, TempleStandsFreeOfItsBlackBackground) {
    GRIPSCAN_TEST_DATA(folder, "temple-turn");
    const auto rig = load_rig(folder / "rig.yaml");
    ASSERT_TRUE(rig) << rig.error().message;
    const Box region{{-0.0389577, -0.117285, 0.488813}, {0.10946, 0.0719538, 0.653261}};
    StereoSettings settings;
    settings.crop_to_region = false;
    for (int i = 0; i < 9; ++i) {
        const auto result = recorded(folder / "frames", *rig, fmt::format("00{}_left.png", i),
                                     fmt::format("00{}_right.png", i), region, settings);
        ASSERT_TRUE(result) << result.error().message;
        double inside = 0.0, dark = 0.0;
        const Cloud& cloud = result->cloud;
        for (std::size_t k = 0; k < cloud.size(); ++k) {
            inside += region.contains(cloud.points[k].cast<double>()) ? 1.0 : 0.0;
            dark += cloud.intensity[k] < 25.0F ? 1.0 : 0.0;
        }
        const double n = static_cast<double>(cloud.size());
        std::cout << "temple " << i << ": " << n << " points, inside " << inside / n << ", dark "
                  << dark / n << ", row error " << result->health.row_error_px << " px\n";
        EXPECT_GT(n, 35000.0);
        EXPECT_GT(inside / n, 0.97);
        EXPECT_LT(dark / n, 0.05);
    }
}

/// The body of the part is a cylinder about the axis of its turn, whose direction is known.
TEST(StereoCloudRecordings, RenderedPartIsThere) {
    GRIPSCAN_TEST_DATA(folder, "rendered-part");
    const auto rig = load_rig(folder / "rig.yaml");
    ASSERT_TRUE(rig) << rig.error().message;
    const Box region{{-0.2, -0.11, 0.6}, {0.145, 0.13, 0.88}};
    for (const int i : {0, 6, 12}) {
        const auto result = recorded(folder / "frames", *rig, fmt::format("{:03}_left.png", i),
                                     fmt::format("{:03}_right.png", i), region, {});
        ASSERT_TRUE(result) << result.error().message;
        std::cout << "rendered part " << i << ": " << result->cloud.size() << " points, row error "
                  << result->health.row_error_px << " px\n";
        // Body, rod and flange cover about 18,000 px; their outer rims and every small step between
        // them are cut.
        EXPECT_GT(result->cloud.size(), 11000U);
        EXPECT_LT(std::abs(result->health.row_error_px), 0.1);
    }
}

TEST(StereoCloudRecordings, BumblebeeScenesBecomeClouds) {
    GRIPSCAN_TEST_DATA(folder, "bumblebee2");
    std::vector<std::filesystem::path> lefts, rights;
    for (int i = 1; i <= 11; ++i) {
        lefts.push_back(folder / "chess" / fmt::format("left{:02}.jpg", i));
        rights.push_back(folder / "chess" / fmt::format("right{:02}.jpg", i));
    }
    const auto rig =
        calibrate_stereo(lefts, rights, Chessboard{4, 6, 0.030}, {}, Progress{}, for_each_in_order);
    ASSERT_TRUE(rig) << rig.error().message;
    StereoSettings settings;
    settings.num_disparities = 96;
    for (const auto& [name, depth_m] : {std::pair{"chair01", 1.44}, std::pair{"garden01", 2.24}}) {
        const auto result = recorded(folder / "scenes", rig->rig, fmt::format("{}_left.jpg", name),
                                     fmt::format("{}_right.jpg", name), std::nullopt, settings);
        ASSERT_TRUE(result) << result.error().message;
        std::vector<float> z;
        for (const auto& p : result->cloud.points) z.push_back(p.z());
        std::nth_element(z.begin(), z.begin() + static_cast<std::ptrdiff_t>(z.size() / 2), z.end());
        std::cout << name << ": " << z.size() << " points, median depth " << z[z.size() / 2]
                  << " m, row error " << result->health.row_error_px << " px\n";
        // Walls and floor of the chair's room have no texture; rims and small steps are cut.
        EXPECT_GT(z.size(), 640U * 480U / 4);
        // Median of another matcher's valid pixels: the same scene, not the same pixels.
        EXPECT_NEAR(static_cast<double>(z[z.size() / 2]), depth_m, 0.25 * depth_m);
        EXPECT_LT(std::abs(result->health.row_error_px), 0.2);
    }
}

}  // namespace
}  // namespace gripscan::test
