#include "ui/layout/window_layout.h"

#include <gtest/gtest.h>

#include <array>
#include <limits>

#include "core/base/seeded_random.h"

namespace gripscan::ui {
namespace {

std::array<std::pair<const char*, Rect>, 11> regions(const WindowLayout& l) {
    return {{{"top bar", l.top_bar},
             {"stage bar", l.stage_bar},
             {"stereo", l.stereo},
             {"3D view", l.view3d},
             {"step card", l.step_card},
             {"table", l.table},
             {"history", l.history},
             {"status bar", l.status_bar},
             {"splitter of stereo", l.splitter_stereo},
             {"splitter of the right column", l.splitter_right},
             {"splitter of the dock", l.splitter_bottom}}};
}

void expect_sound(const WindowLayout& l, int width, int height) {
    const Rect window{0, 0, width, height};
    const auto all = regions(l);
    for (std::size_t i = 0; i < all.size(); ++i) {
        const auto& [name, rect] = all[i];
        EXPECT_GE(rect.width, 0) << name;
        EXPECT_GE(rect.height, 0) << name;
        EXPECT_TRUE(rect.empty() || rect.inside(window)) << name;
        for (std::size_t j = i + 1; j < all.size(); ++j) {
            EXPECT_FALSE(rect.overlaps(all[j].second)) << name << " and " << all[j].first;
        }
    }
}

TEST(WindowLayout, NothingOverlapsOrLeavesTheWindowWhateverTheSizeSplitsAndScale) {
    SeededRandom random(1);
    for (int i = 0; i < 5000; ++i) {
        const int width = static_cast<int>(random.uniform(0, 4000));
        const int height = static_cast<int>(random.uniform(0, 2400));
        const Scale scale(static_cast<float>(random.uniform(0.3, 5.0)));
        const Splits splits{static_cast<float>(random.uniform(-500, 3000)),
                            static_cast<float>(random.uniform(-500, 3000)),
                            static_cast<float>(random.uniform(-500, 3000))};
        SCOPED_TRACE(testing::Message() << width << " x " << height << " at " << scale.factor());
        expect_sound(layout_window(width, height, splits, scale), width, height);
        if (HasFailure()) return;
    }
}

TEST(WindowLayout, SplitsThatAreNoNumbersAreReplacedByTheLeast) {
    const float nan = std::numeric_limits<float>::quiet_NaN();
    const auto l = layout_window(1600, 1000, {nan, nan, nan}, Scale(nan));
    expect_sound(l, 1600, 1000);
    EXPECT_EQ(l.stereo.width, 264);
    EXPECT_EQ(l.step_card.width, 336);
}

TEST(WindowLayout, IsThatOfTheDesignAt1600x1000) {
    const auto l = layout_window(1600, 1000, default_splits(1600, 1000, Scale()), Scale());
    EXPECT_EQ(l.stereo, (Rect{0, 94, 312, 578}));
    EXPECT_EQ(l.view3d, (Rect{316, 94, 900, 578}));
    EXPECT_EQ(l.step_card, (Rect{1220, 94, 380, 578}));
    EXPECT_EQ(l.table, (Rect{0, 676, 1216, 294}));
    EXPECT_EQ(l.history, (Rect{1220, 676, 380, 294}));
    EXPECT_EQ(l.status_bar, (Rect{0, 970, 1600, 30}));
    EXPECT_EQ(l.detail, Detail{});
}

TEST(WindowLayout, At200PercentOnTwiceThePixelsIsTheSameTwiceAsLarge) {
    const auto one = layout_window(1600, 1000, {}, Scale(1.0F));
    const auto two = layout_window(3200, 2000, {}, Scale(2.0F));
    const auto small = regions(one);
    const auto large = regions(two);
    for (std::size_t i = 0; i < small.size(); ++i) {
        const Rect& s = small[i].second;
        EXPECT_EQ(large[i].second, (Rect{2 * s.x, 2 * s.y, 2 * s.width, 2 * s.height}))
            << small[i].first;
    }
    EXPECT_EQ(one.detail, two.detail);
}

TEST(WindowLayout, A1600x1000WindowAt125PercentCountsAsASmallOne) {
    EXPECT_TRUE(layout_window(1600, 1000, {}, Scale(1.25F)).detail.full_right_column);
}

TEST(WindowLayout, At1280x800CriteriaAndLabelsGiveWayButNeverTheStepCard) {
    const auto l = layout_window(1280, 800, default_splits(1280, 800, Scale()), Scale());
    EXPECT_FALSE(l.detail.stage_criteria);
    EXPECT_FALSE(l.detail.tool_labels);
    EXPECT_TRUE(l.detail.log_is_a_tab);
    EXPECT_FALSE(l.detail.stereo_is_a_tab);
    EXPECT_EQ(l.stage_bar.height, 36);
    EXPECT_EQ(l.stereo.width, 264);
    EXPECT_EQ(l.view3d.width, 672);
    EXPECT_EQ(l.step_card, (Rect{944, 76, 336, 540}));
    EXPECT_EQ(l.history.bottom(), l.status_bar.y);
    EXPECT_GE(l.history.height, 132);
}

TEST(WindowLayout, Below1120x700TheLeftColumnBecomesATab) {
    for (const auto& [width, height] : {std::pair{1119, 800}, {1280, 699}}) {
        const auto l = layout_window(width, height, {}, Scale());
        EXPECT_TRUE(l.detail.stereo_is_a_tab);
        EXPECT_TRUE(l.stereo.empty());
        EXPECT_TRUE(l.splitter_stereo.empty());
        EXPECT_EQ(l.view3d.x, 0);
    }
}

TEST(WindowLayout, TheStepCardNeverScrollsFrom1280x800On) {
    SeededRandom random(2);
    for (int i = 0; i < 1000; ++i) {
        const int width = static_cast<int>(random.uniform(1280, 4000));
        const int height = static_cast<int>(random.uniform(800, 2400));
        const auto l = layout_window(
            width, height, {312, 380, static_cast<float>(random.uniform(0, 3000))}, Scale());
        EXPECT_GE(l.step_card.height, l.detail.full_right_column ? 540 : 578);
        EXPECT_GE(l.view3d.width, 480);
        EXPECT_GE(l.view3d.height, 360);
        EXPECT_GE(l.table.height, 172);
    }
}

TEST(WindowLayout, ASplitterMovesItsEdgeByAsMuchAsTheMouse) {
    const Splits start = default_splits(1600, 1000, Scale());
    const auto before = layout_window(1600, 1000, start, Scale());
    const auto edge = [&](Splitter which, int by) {
        return layout_window(1600, 1000, dragged(start, which, by, 1600, 1000, Scale()), Scale());
    };
    EXPECT_EQ(edge(Splitter::kStereo, 30).splitter_stereo.x, before.splitter_stereo.x + 30);
    EXPECT_EQ(edge(Splitter::kRight, -25).splitter_right.x, before.splitter_right.x - 25);
    // The step card stands above the dock and keeps its height: the dock shrinks but does not grow.
    EXPECT_EQ(edge(Splitter::kBottom, 20).splitter_bottom.y, before.splitter_bottom.y + 20);
    EXPECT_EQ(edge(Splitter::kBottom, -20).splitter_bottom.y, before.splitter_bottom.y);
}

TEST(WindowLayout, DraggingFarAndBackLeavesNoHiddenTravel) {
    // After a drag beyond the limit the first px back moves the edge.
    const Splits far = dragged({}, Splitter::kStereo, 5000, 1600, 1000, Scale());
    const Splits back = dragged(far, Splitter::kStereo, -1, 1600, 1000, Scale());
    EXPECT_EQ(far.stereo_width, 480.0F);
    EXPECT_EQ(back.stereo_width, 479.0F);
}

TEST(Scale, IsKeptWithinWhatCanBeRead) {
    EXPECT_EQ(Scale(0.0F).factor(), 0.5F);
    EXPECT_EQ(Scale(100.0F).factor(), 4.0F);
    EXPECT_EQ(Scale(std::numeric_limits<float>::infinity()).factor(), 1.0F);
    EXPECT_EQ(Scale(1.5F).em(1.0F), 21.0F);
    EXPECT_EQ(Scale(1.49F).line(), 1.0F);
    EXPECT_EQ(Scale(1.5F).line(), 2.0F);
    EXPECT_EQ(Scale(2.5F).line(), 3.0F);
}

}  // namespace
}  // namespace gripscan::ui
