#include "core/cloud/filters.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <set>
#include <thread>

#include "core/base/units.h"
#include "core/cloud/cloud_file.h"
#include "tests/support/test_data.h"
#include "tests/unit/cloud/sample_clouds.h"

namespace gripscan {
namespace {

constexpr double kRadius_m = 0.08;
const Eigen::Vector3d kCentre_m(0.02, -0.01, 0.75);

/// A camera's view of a ball in front of a wall: organised, noise along the ray.
Cloud ball_and_wall(std::uint64_t seed, double noise_m, bool viewpoint_known) {
    SeededRandom random(seed);
    Cloud cloud;
    cloud.grid_width = 320;
    cloud.grid_height = 240;
    for (int row = 0; row < cloud.grid_height; ++row) {
        for (int column = 0; column < cloud.grid_width; ++column) {
            const Eigen::Vector3d ray =
                Eigen::Vector3d((column - 160) / 500.0, (row - 120) / 500.0, 1.0).normalized();
            const double along = ray.dot(kCentre_m);
            const double gap = kRadius_m * kRadius_m - (kCentre_m.squaredNorm() - along * along);
            const double range = gap > 0.0 ? along - std::sqrt(gap) : 1.0 / ray.z();
            const Eigen::Vector3d p = ray * (range + noise_m * random.normal());
            cloud.points.push_back(p.cast<float>());
            cloud.cell.push_back(row * cloud.grid_width + column);
        }
    }
    if (viewpoint_known) cloud.viewpoint = Eigen::Vector3f::Zero();
    return cloud;
}

bool on_ball(const Eigen::Vector3f& p) {
    const double distance = (p.cast<double>() - kCentre_m).norm();
    // Not its rim: there the window sees both surfaces and few points.
    return distance < 1.1 * kRadius_m && p.z() < kCentre_m.z() - 0.3 * kRadius_m;
}

/// Share of the ball's points whose normal is within the limit of the true one, sign included.
double share_of_good_normals(const Cloud& cloud, double limit_deg) {
    std::size_t good = 0;
    std::size_t all = 0;
    for (std::size_t i = 0; i < cloud.size(); ++i) {
        if (!on_ball(cloud.points[i])) continue;
        const Eigen::Vector3d truth = (cloud.points[i].cast<double>() - kCentre_m).normalized();
        ++all;
        if (cloud.normals[i].cast<double>().dot(truth) > std::cos(rad_from_deg(limit_deg))) ++good;
    }
    EXPECT_GT(all, 500U);
    return static_cast<double>(good) / static_cast<double>(all);
}

// Slope error of a plane through 7 x 7 points, 1.4 mm apart, with 0.2 mm noise:
// 0.2 / (1.4 · √196) = 0.6 deg. Where the ball turns away the window lies lopsided on it and adds
// up to a degree. Four sigmas and that.
constexpr double kNormalLimit_deg = 3.4;

TEST(EstimateNormals, FromTheGridTowardsTheViewpoint) {
    for (const std::uint64_t seed : {1, 2, 3}) {
        Cloud cloud = ball_and_wall(seed, 0.0002, true);
        estimate_normals(cloud, {}, for_each_in_order);
        ASSERT_EQ(cloud.normals.size(), cloud.size());
        EXPECT_GT(share_of_good_normals(cloud, kNormalLimit_deg), 0.97);
        for (const auto& n : cloud.normals) ASSERT_NEAR(n.norm(), 1.0F, 1e-5F);
    }
}

TEST(EstimateNormals, WithoutAViewpointTheGridKeepsOneSide) {
    Cloud cloud = ball_and_wall(4, 0.0002, false);
    estimate_normals(cloud, {}, for_each_in_order);
    // Nobody knows which side is outside, but it must be the same one everywhere.
    const double outside = share_of_good_normals(cloud, kNormalLimit_deg);
    for (auto& n : cloud.normals) n = -n;
    const double inside = share_of_good_normals(cloud, kNormalLimit_deg);
    EXPECT_GT(std::max(outside, inside), 0.95);
}

TEST(EstimateNormals, WithoutAGridFromTheNearestPoints) {
    Cloud cloud = ball_and_wall(5, 0.0001, true);
    cloud.cell.clear();
    cloud.grid_width = 0;
    cloud.grid_height = 0;
    estimate_normals(cloud, {}, for_each_in_order);
    EXPECT_GT(share_of_good_normals(cloud, 5.0), 0.97);
}

TEST(EstimateNormals, UnknownOutsideIsAwayFromTheCentroid) {
    SeededRandom random(6);
    Cloud cloud;
    for (int i = 0; i < 5000; ++i) {
        const Eigen::Vector3d direction(random.normal(), random.normal(), random.normal());
        cloud.points.push_back((kCentre_m + kRadius_m * direction.normalized()).cast<float>());
    }
    estimate_normals(cloud, {}, for_each_in_order);
    EXPECT_GT(share_of_good_normals(cloud, 5.0), 0.99);
}

TEST(EstimateNormals, FewOrUselessPoints) {
    Cloud two;
    two.points = {{0, 0, 1}, {0, 1, 1}};
    estimate_normals(two, {}, for_each_in_order);
    EXPECT_TRUE(two.normals.empty());

    Cloud line;
    for (int i = 0; i < 30; ++i)
        line.points.emplace_back(0.0F, 0.01F * static_cast<float>(i), 1.0F);
    estimate_normals(line, {}, for_each_in_order);
    for (const auto& n : line.normals) EXPECT_NEAR(n.norm(), 1.0F, 1e-5F);

    Cloud same;
    same.points.assign(30, Eigen::Vector3f(0, 0, 0));
    estimate_normals(same, {}, for_each_in_order);
    for (const auto& n : same.normals) EXPECT_NEAR(n.norm(), 1.0F, 1e-5F);
}

/// Two threads that take turns: even and odd numbers.
void for_each_on_two_threads(std::size_t n, const std::function<void(std::size_t)>& body) {
    const auto every_second = [&](std::size_t first) {
        for (std::size_t i = first; i < n; i += 2) body(i);
    };
    const std::jthread other(every_second, 1);
    every_second(0);
}

TEST(Filters, GiveTheSameBitsForAnyNumberOfThreads) {
    for (const bool grid : {true, false}) {
        Cloud one = ball_and_wall(7, 0.0002, true);
        if (!grid) one.cell.clear();
        Cloud two = one;
        estimate_normals(one, {}, for_each_in_order);
        estimate_normals(two, {}, for_each_on_two_threads);
        EXPECT_EQ(one.normals, two.normals);
        EXPECT_EQ(noise_estimate_m(one, for_each_in_order),
                  noise_estimate_m(two, for_each_on_two_threads));
    }
}

TEST(NoiseEstimate, FindsTheNoiseAndNotTheFlyingPixels) {
    for (const double noise_m : {0.0002, 0.0005, 0.001}) {
        SeededRandom random(static_cast<std::uint64_t>(noise_m * 1e6));
        Cloud cloud;
        for (int i = 0; i < 20000; ++i) {
            const double off = random.uniform() < 0.02 ? 0.05 * random.uniform() : 0.0;
            cloud.points.emplace_back(static_cast<float>(random.uniform(-0.1, 0.1)),
                                      static_cast<float>(random.uniform(-0.1, 0.1)),
                                      static_cast<float>(0.7 + noise_m * random.normal() + off));
        }
        // Where the noise reaches the spacing (1.4 mm) the nearest points are not those of the
        // plane and the estimate falls short.
        const double tolerance = noise_m < 0.0004 ? 0.05 : 0.25;
        EXPECT_NEAR(noise_estimate_m(cloud, for_each_in_order) / noise_m, 1.0, tolerance)
            << noise_m;
    }
    EXPECT_EQ(noise_estimate_m(Cloud{}, for_each_in_order), 0.0);
}

TEST(NoiseEstimate, OfAScannerIsTenthsOfAMillimetre) {
    GRIPSCAN_TEST_DATA(folder, "bunny");
    const auto cloud = load_cloud(folder / "bun000.ply");
    ASSERT_TRUE(cloud) << cloud.error().message;
    const double noise_m = noise_estimate_m(*cloud, for_each_in_order);
    EXPECT_GT(noise_m, 0.00001);
    EXPECT_LT(noise_m, 0.0003);
}

TEST(Thinned, OnePointAVoxelWithTheMeanOfAll) {
    const Cloud cloud = test::random_cloud(11, 3000, test::kFieldSets - 1);
    const double voxel_m = 0.05;
    const Cloud thin = thinned(cloud, voxel_m);
    ASSERT_LT(thin.size(), cloud.size());
    EXPECT_FALSE(thin.organised());
    EXPECT_EQ(thin.viewpoint, cloud.viewpoint);
    EXPECT_EQ(thin.normals.size(), thin.size());
    EXPECT_EQ(thin.intensity.size(), thin.size());
    EXPECT_EQ(thin.sigma.size(), thin.size());
    EXPECT_EQ(thin.seen.size(), thin.size());

    const auto voxel_of = [&](const Eigen::Vector3f& p) {
        const Eigen::Vector3d v = (p.cast<double>() / voxel_m).array().floor();
        return std::array<double, 3>{v.x(), v.y(), v.z()};
    };
    std::set<std::array<double, 3>> voxels;
    for (const auto& p : cloud.points) voxels.insert(voxel_of(p));
    EXPECT_EQ(thin.size(), voxels.size());

    const auto first = voxel_of(cloud.points[0]);
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    std::uint16_t seen = 0;
    int members = 0;
    for (std::size_t i = 0; i < cloud.size(); ++i) {
        if (voxel_of(cloud.points[i]) != first) continue;
        sum += cloud.points[i].cast<double>();
        seen = std::max(seen, cloud.seen[i]);
        ++members;
    }
    EXPECT_LT((thin.points[0].cast<double>() - sum / members).norm(), 1e-7);
    EXPECT_EQ(thin.seen[0], seen);
    for (const auto& n : thin.normals) EXPECT_NEAR(n.norm(), 1.0F, 1e-5F);
}

TEST(Thinned, IsIdempotentUpToPointsThatChangeVoxelAndKeepsNothingOfNothing) {
    const Cloud thin = thinned(test::random_cloud(12, 3000, test::kNormals), 0.05);
    EXPECT_EQ(thinned(thin, 0.05).size(), thin.size());
    EXPECT_TRUE(thinned(Cloud{}, 0.01).empty());
}

}  // namespace
}  // namespace gripscan
