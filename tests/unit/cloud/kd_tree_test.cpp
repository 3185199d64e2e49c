#include "core/cloud/kd_tree.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <thread>

#include "core/base/seeded_random.h"

namespace gripscan {
namespace {

std::vector<Eigen::Vector3f> random_points(std::uint64_t seed, std::size_t n) {
    SeededRandom random(seed);
    std::vector<Eigen::Vector3f> points(n);
    for (auto& p : points) {
        for (float& x : p) x = static_cast<float>(random.uniform(-0.1, 0.1));
    }
    return points;
}

/// The obvious answer: squared distances to all points, sorted.
std::vector<float> sorted_distances(const std::vector<Eigen::Vector3f>& points,
                                    const Eigen::Vector3f& query) {
    std::vector<float> distances;
    for (const auto& p : points) distances.push_back((p - query).squaredNorm());
    std::sort(distances.begin(), distances.end());
    return distances;
}

// Distances of the tree and of the plain loop may differ in the last bits.
constexpr float kRounding = 1e-9F;

TEST(KdTree, AgreesWithThePlainSearch) {
    for (const std::uint64_t seed : {1, 2, 3}) {
        const auto points = random_points(seed, 2000);
        const auto queries = random_points(seed + 100, 200);
        const KdTree tree(points);
        std::vector<Neighbour> found;
        for (const auto& q : queries) {
            const auto truth = sorted_distances(points, q);
            const auto nearest = tree.nearest(q);
            ASSERT_TRUE(nearest.has_value());
            EXPECT_NEAR(nearest->squared_distance_m2, truth[0], kRounding);
            EXPECT_NEAR((points[nearest->index] - q).squaredNorm(), truth[0], kRounding);

            tree.k_nearest(q, 12, found);
            ASSERT_EQ(found.size(), 12U);
            for (std::size_t i = 0; i < found.size(); ++i) {
                EXPECT_NEAR(found[i].squared_distance_m2, truth[i], kRounding);
            }

            const float radius_m = 0.02F;
            tree.all_within(q, radius_m, found);
            const auto inside = std::lower_bound(truth.begin(), truth.end(), radius_m * radius_m);
            EXPECT_EQ(found.size(), static_cast<std::size_t>(inside - truth.begin()));

            const auto close = tree.nearest_within(q, radius_m);
            EXPECT_EQ(close.has_value(), truth[0] < radius_m * radius_m);
            if (close) {
                EXPECT_EQ(close->index, nearest->index);
            }
        }
    }
}

TEST(KdTree, NoPointsHaveNoNeighbours) {
    const KdTree tree(std::vector<Eigen::Vector3f>{});
    std::vector<Neighbour> found(3);
    EXPECT_FALSE(tree.nearest({0, 0, 0}).has_value());
    EXPECT_FALSE(tree.nearest_within({0, 0, 0}, 1.0F).has_value());
    tree.k_nearest({0, 0, 0}, 5, found);
    EXPECT_TRUE(found.empty());
    EXPECT_EQ(tree.size(), 0U);
}

TEST(KdTree, FewerPointsThanAskedForAndEqualPoints) {
    const KdTree tree(std::vector<Eigen::Vector3f>(40, Eigen::Vector3f(1, 2, 3)));
    std::vector<Neighbour> found;
    tree.k_nearest({1, 2, 3}, 100, found);
    EXPECT_EQ(found.size(), 40U);
    tree.k_nearest({1, 2, 3}, 0, found);
    EXPECT_TRUE(found.empty());
}

TEST(KdTree, OwnsItsPoints) {
    auto points = random_points(7, 500);
    const KdTree built(points);
    const auto before = built.nearest({0, 0, 0});
    std::fill(points.begin(), points.end(), Eigen::Vector3f::Zero());
    const auto after = built.nearest({0, 0, 0});
    EXPECT_EQ(before->index, after->index);
    EXPECT_EQ(before->squared_distance_m2, after->squared_distance_m2);
}

TEST(KdTree, AnswersThreadsSideBySide) {
    const auto points = random_points(9, 5000);
    const KdTree tree(points);
    const auto queries = random_points(10, 2000);
    std::vector<std::uint32_t> first(queries.size());
    std::vector<std::uint32_t> second(queries.size());
    const auto ask = [&](std::vector<std::uint32_t>& answers) {
        for (std::size_t i = 0; i < queries.size(); ++i) {
            answers[i] = tree.nearest(queries[i])->index;
        }
    };
    {
        const std::jthread a([&] { ask(first); });
        const std::jthread b([&] { ask(second); });
    }
    EXPECT_EQ(first, second);
}

}  // namespace
}  // namespace gripscan
