#include "ui/render/level_of_detail.h"

#include <gtest/gtest.h>

#include <vector>

#include "core/base/seeded_random.h"

namespace gripscan::ui {
namespace {

TEST(LevelOfDetail, DrawsASmallCloudAtOnce) {
    LevelOfDetail detail;
    const Slice slice = detail.next(1000, true);
    EXPECT_TRUE(slice.clear);
    EXPECT_EQ(slice.first(1000), 0U);
    EXPECT_EQ(slice.end(1000), 1000U);
    EXPECT_TRUE(detail.complete());
    EXPECT_TRUE(detail.next(1000, false).empty());
}

TEST(LevelOfDetail, OfNothingIsComplete) {
    LevelOfDetail detail;
    EXPECT_TRUE(detail.next(0, true).clear);
    EXPECT_TRUE(detail.complete());
}

TEST(LevelOfDetail, SlicesOfAStillPictureMeetWithoutGapOrOverlap) {
    SeededRandom random(1);
    for (int run = 0; run < 50; ++run) {
        const auto size = static_cast<std::size_t>(random.uniform(1, 400000));
        const auto total = size + static_cast<std::size_t>(random.uniform(0, 5e6));
        LevelOfDetail detail;
        std::size_t next = 0;
        const bool coarse = detail.next(total, true).coarse;
        EXPECT_EQ(detail.complete(), !coarse);
        for (bool first = true; !detail.complete(); first = false) {
            const Slice slice = detail.next(total, false);
            EXPECT_EQ(slice.first(size), next);
            EXPECT_EQ(slice.clear, first);
            EXPECT_FALSE(slice.coarse);
            next = slice.end(size);
            detail.measured(random.uniform(1.0, 100.0));
        }
        EXPECT_EQ(next, coarse ? size : 0U);
    }
}

TEST(LevelOfDetail, AChangeBeginsAnew) {
    LevelOfDetail detail;
    (void)detail.next(5000000, true);
    (void)detail.next(5000000, false);
    const Slice slice = detail.next(5000000, true);
    EXPECT_EQ(slice.from, 0.0);
    EXPECT_TRUE(slice.clear);
    EXPECT_TRUE(slice.coarse);
    EXPECT_FALSE(detail.complete());
}

/// Frames of a machine that needs `fixed` ms and `us` microseconds a point.
double settled_frame_ms(LevelOfDetail& detail, double fixed, double us) {
    double frame = 0.0;
    for (int i = 0; i < 80; ++i) {
        const Slice slice = detail.next(5000000, true);
        frame = fixed + 1e-3 * us * 5e6 * slice.to;
        detail.measured(frame);
    }
    return frame;
}

TEST(LevelOfDetail, FindsTheBudgetOfSlowAndFastMachines) {
    for (const double us : {0.02, 0.1, 0.3}) {
        LevelOfDetail detail(28.0);
        EXPECT_NEAR(settled_frame_ms(detail, 12.0, us), 28.0, 3.0) << us;
    }
}

TEST(LevelOfDetail, OneSlowFrameTakesBackAtMostHalf) {
    LevelOfDetail detail(28.0);
    (void)settled_frame_ms(detail, 12.0, 0.1);
    const auto before = detail.budget();
    (void)detail.next(5000000, true);
    detail.measured(1000.0);
    EXPECT_GE(detail.budget(), before / 2 - 1);
    EXPECT_LT(detail.budget(), before);
}

TEST(LevelOfDetail, AFrameThatDrewLittleDoesNotRaiseTheBudget) {
    LevelOfDetail detail;
    const auto before = detail.budget();
    for (int i = 0; i < 100; ++i) {
        (void)detail.next(1000, true);
        detail.measured(2.0);
    }
    EXPECT_EQ(detail.budget(), before);
}

}  // namespace
}  // namespace gripscan::ui
