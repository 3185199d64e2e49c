// Which points of a template are kept, against points whose fate is known beforehand.
#include "core/registration/template_filter.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <numeric>
#include <set>

#include "core/base/seeded_random.h"
#include "core/concurrency/worker_pool.h"

namespace gripscan {
namespace {

using testing::Each;
using testing::ElementsAre;
using testing::Ge;
using testing::IsEmpty;

constexpr int kSide = 60;
constexpr double kSpacing_m = 1e-3;

/// A square grid of kSide² points in z = 0, seen by 1 + column mod 5 views.
Cloud plate() {
    Cloud cloud;
    for (int row = 0; row < kSide; ++row) {
        for (int column = 0; column < kSide; ++column) {
            cloud.points.emplace_back(static_cast<float>(column * kSpacing_m),
                                      static_cast<float>(row * kSpacing_m), 0.0F);
            cloud.seen.push_back(static_cast<std::uint16_t>(1 + column % 5));
        }
    }
    return cloud;
}

/// Points far from the plate and from each other; returns their indices.
std::set<std::size_t> plant_outliers(Cloud& cloud, int count, std::uint64_t seed) {
    SeededRandom random(seed);
    std::set<std::size_t> planted;
    for (int i = 0; i < count; ++i) {
        planted.insert(cloud.size());
        cloud.points.emplace_back(static_cast<float>(random.uniform(0.0, 0.06)),
                                  static_cast<float>(random.uniform(0.0, 0.06)),
                                  0.05F + 0.03F * static_cast<float>(i));
        cloud.seen.push_back(5);
    }
    return planted;
}

TEST(TemplateFilter, KeepsEverythingUnlessAsked) {
    const Cloud cloud = plate();
    const auto result = filter_template(cloud, {}, for_each_in_order);
    std::vector<std::size_t> all(cloud.size());
    std::iota(all.begin(), all.end(), 0);
    EXPECT_EQ(result.kept, all);
    EXPECT_EQ(result.counts.all, cloud.size());
    EXPECT_EQ(result.counts.cut_off + result.counts.too_few + result.counts.outliers, 0U);
}

TEST(TemplateFilter, CropAndItsInverseShareThePointsOut) {
    const Cloud cloud = plate();
    TemplateFilter filter;
    // 10 columns and 20 rows; the sides lie between points.
    filter.crop = Box{{-0.5e-3, -0.5e-3, -1e-3}, {9.5e-3, 19.5e-3, 1e-3}};
    const auto inside = filter_template(cloud, filter, for_each_in_order);
    EXPECT_EQ(inside.counts.kept, 200U);
    EXPECT_EQ(inside.counts.cut_off, cloud.size() - 200U);
    filter.invert_crop = true;
    const auto outside = filter_template(cloud, filter, for_each_in_order);
    EXPECT_EQ(outside.counts.kept, cloud.size() - 200U);
    std::set<std::size_t> both(inside.kept.begin(), inside.kept.end());
    both.insert(outside.kept.begin(), outside.kept.end());
    EXPECT_EQ(both.size(), cloud.size());
}

TEST(TemplateFilter, ACropWithoutVolumeHoldsNothing) {
    TemplateFilter filter;
    filter.crop = Box{{0.01, 0, 0}, {-0.01, 0, 0}};
    EXPECT_THAT(filter_template(plate(), filter, for_each_in_order).kept, IsEmpty());
}

TEST(TemplateFilter, InvertedWithoutACropKeepsEverything) {
    TemplateFilter filter;
    filter.invert_crop = true;
    EXPECT_EQ(filter_template(plate(), filter, for_each_in_order).counts.kept, plate().size());
}

TEST(TemplateFilter, CountsHowOftenPointsInsideTheCropWereSeen) {
    const Cloud cloud = plate();
    TemplateFilter filter;
    filter.crop = Box{{-0.5e-3, -0.5e-3, -1e-3}, {6.5e-3, 9.5e-3, 1e-3}};  // columns 0 … 6
    filter.min_seen = 3;
    const auto result = filter_template(cloud, filter, for_each_in_order);
    EXPECT_THAT(result.counts.seen_by, ElementsAre(0U, 20U, 20U, 10U, 10U, 10U));
    EXPECT_EQ(result.counts.too_few, 40U);
    EXPECT_EQ(result.counts.kept, 30U);
    std::vector<int> seen;
    for (const std::size_t i : result.kept) seen.push_back(cloud.seen[i]);
    EXPECT_THAT(seen, Each(Ge(3)));
}

TEST(TemplateFilter, ACloudThatDoesNotKnowItsViewsPassesTheSeenCount) {
    Cloud cloud = plate();
    cloud.seen.clear();
    TemplateFilter filter;
    filter.min_seen = 4;
    const auto result = filter_template(cloud, filter, for_each_in_order);
    EXPECT_EQ(result.counts.kept, cloud.size());
    EXPECT_THAT(result.counts.seen_by, IsEmpty());
}

class PlantedOutliers : public testing::TestWithParam<int> {};

// A point of the plate has its 8 neighbours within 2.3 spacings, a planted one none of 8 within
// 50 mm on average. 10 such, some 0.1 m out, make a standard deviation of about 6 mm, so the limit
// of 3 sigmas, some 20 mm, lies between the two kinds with room to spare.
TEST_P(PlantedOutliers, AreFoundAndNothingElse) {
    Cloud cloud = plate();
    const auto planted = plant_outliers(cloud, 10, static_cast<std::uint64_t>(GetParam()));
    TemplateFilter filter;
    filter.denoise_sigmas = 3.0;
    filter.denoise_neighbours = 8;
    const auto result = filter_template(cloud, filter, for_each_in_order);
    EXPECT_EQ(result.counts.outliers, planted.size());
    for (const std::size_t i : result.kept) EXPECT_FALSE(planted.contains(i)) << i;
    EXPECT_EQ(result.counts.kept, plate().size());
}

TEST_P(PlantedOutliers, AreTheSameForAnyNumberOfThreads) {
    Cloud cloud = plate();
    SeededRandom random(static_cast<std::uint64_t>(GetParam()));
    for (auto& p : cloud.points) p.z() += static_cast<float>(random.normal() * 2e-4);
    TemplateFilter filter;
    filter.denoise_sigmas = 1.0;
    const auto alone = filter_template(cloud, filter, for_each_in_order);
    WorkerPool pool(3);
    const auto together = filter_template(cloud, filter, pool.for_each());
    EXPECT_EQ(alone.kept, together.kept);
    EXPECT_GT(alone.counts.outliers, 0U);
}

TEST_P(PlantedOutliers, ASmallerLimitNeverKeepsMore) {
    Cloud cloud = plate();
    SeededRandom random(static_cast<std::uint64_t>(GetParam()));
    for (auto& p : cloud.points) p.z() += static_cast<float>(random.normal() * 5e-4);
    TemplateFilter filter;
    std::size_t before = 0;
    for (const double sigmas : {0.5, 1.0, 2.0, 4.0}) {
        filter.denoise_sigmas = sigmas;
        const std::size_t kept = filter_template(cloud, filter, for_each_in_order).counts.kept;
        EXPECT_GE(kept, before) << sigmas;
        before = kept;
    }
}

INSTANTIATE_TEST_SUITE_P(Seeds, PlantedOutliers, testing::Values(1, 2, 3));

TEST(TemplateFilter, OutliersAreSoughtAmongWhatIsLeft) {
    Cloud cloud = plate();
    const auto planted = plant_outliers(cloud, 10, 1);
    TemplateFilter filter;
    filter.crop = Box{{-1, -1, -0.01}, {1, 1, 0.01}};
    filter.denoise_sigmas = 20.0;  // no point of a plate lies so far out
    const auto result = filter_template(cloud, filter, for_each_in_order);
    EXPECT_EQ(result.counts.cut_off, planted.size());
    EXPECT_EQ(result.counts.outliers, 0U);
}

TEST(TemplateFilter, TakesEmptyCloudsAndSinglePoints) {
    TemplateFilter filter;
    filter.denoise_sigmas = 1.0;
    EXPECT_THAT(filter_template({}, filter, for_each_in_order).kept, IsEmpty());
    Cloud one;
    one.points = {{1, 2, 3}};
    EXPECT_EQ(filter_template(one, filter, for_each_in_order).counts.kept, 1U);
    EXPECT_EQ(template_facts(one, for_each_in_order).spacing_m, 0.0);
    EXPECT_EQ(template_facts({}, for_each_in_order).bounds, std::nullopt);
}

TEST(TemplateFacts, TellSizeSpacingAndNoise) {
    Cloud cloud = plate();
    cloud.sigma.assign(cloud.size(), 2e-4F);
    const TemplateFacts facts = template_facts(cloud, for_each_in_order);
    EXPECT_EQ(facts.points, cloud.size());
    ASSERT_TRUE(facts.bounds);
    // Single precision of coordinates up to 0.06.
    EXPECT_NEAR(facts.bounds->max_m.x() - facts.bounds->min_m.x(), 0.059, 1e-8);
    EXPECT_NEAR(facts.bounds->max_m.z() - facts.bounds->min_m.z(), 0.0, 1e-8);
    EXPECT_NEAR(facts.spacing_m, kSpacing_m, 1e-8);
    EXPECT_NEAR(facts.sigma_m.value(), 2e-4, 1e-9);
    EXPECT_FALSE(facts.has_normals);
}

}  // namespace
}  // namespace gripscan
