#include "ui/views/stereo_facts.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/support/sample_scene.h"

namespace gripscan::ui {
namespace {

const StereoFact* fact(const std::vector<StereoFact>& facts, std::string_view label) {
    const auto found = std::find_if(facts.begin(), facts.end(),
                                    [&](const StereoFact& f) { return f.label == label; });
    return found == facts.end() ? nullptr : &*found;
}

/// Live pictures, the latest of them matched.
void show_live(Snapshot& snapshot) {
    LiveStereo& live = snapshot.live;
    live.picture = test::sample_picture();
    live.matched = live.picture;
    live.matched_facts.fill = 0.93;
    live.matched_facts.row_error_px = 0.08;
    live.matched_facts.row_error_sd_px = 0.004;
    live.number = 400;
    live.on = true;
}

TEST(StereoFacts, AreValuesAgainstTheirLimits) {
    auto scene = test::growing_scene(1, 2000);
    show_live(scene.snapshot);
    scene.snapshot.live.rate_hz = 14.93;
    const ShownPicture shown = shown_picture(scene.snapshot);
    EXPECT_TRUE(shown.live);
    const auto facts = stereo_facts(scene.snapshot, shown);
    ASSERT_NE(fact(facts, "Fill %"), nullptr);
    EXPECT_EQ(fact(facts, "Fill %")->left, "93");
    EXPECT_EQ(fact(facts, "Fill %")->limit, "≥ 10");
    EXPECT_EQ(fact(facts, "Mean level")->state, FactState::kGood);
    EXPECT_EQ(fact(facts, "Saturated %")->right, "0.3");
    EXPECT_EQ(fact(facts, "Row error px")->left, "0.08");
    EXPECT_EQ(fact(facts, "Frames /s")->left, "14.9");
    EXPECT_EQ(fact(facts, "Baseline mm")->left, "120.00");
    for (const StereoFact& f : facts) EXPECT_FALSE(f.tooltip.empty()) << f.label;
}

TEST(StereoFacts, BeyondALimitAreWarnings) {
    auto picture = std::make_shared<StereoPicture>(*test::sample_picture());
    picture->left_health->fill = 0.06;
    picture->right_health->saturated = 0.05;
    picture->left_health->row_error_px = -0.4;
    picture->right_health->mean_intensity = 80.0;
    Snapshot snapshot;
    snapshot.live.lost.late = 3;
    snapshot.live.number = 200;
    const auto facts = stereo_facts(snapshot, {picture, true, "live", {}});
    for (const auto* label : {"Fill %", "Saturated %", "Row error px", "Mean level", "Frames /s"}) {
        ASSERT_NE(fact(facts, label), nullptr) << label;
        EXPECT_EQ(fact(facts, label)->state, FactState::kWarning) << label;
    }
    snapshot.live.number = 400;
    EXPECT_EQ(fact(stereo_facts(snapshot, {picture, true, "live", {}}), "Frames /s")->state,
              FactState::kGood)
        << "one in a hundred is no matter";
}

TEST(StereoFacts, OfALivePairThatIsNotMatchedAreDashesWithTheReason) {
    auto scene = test::growing_scene(1, 2000);
    LiveStereo& live = scene.snapshot.live;
    show_live(scene.snapshot);
    live.why_not_matched = "the turn has the processor to itself";
    auto later = std::make_shared<StereoPicture>(*live.picture);
    later->t_s += 60.0;
    live.picture = later;
    const auto facts = stereo_facts(scene.snapshot, shown_picture(scene.snapshot));
    for (const auto* label : {"Fill %", "Row error px"}) {
        EXPECT_EQ(fact(facts, label)->left, "–") << label;
        EXPECT_EQ(fact(facts, label)->state, FactState::kNone) << label;
        EXPECT_NE(fact(facts, label)->tooltip.find("the processor to itself"), std::string::npos);
    }
    later->t_s -= 58.0;
    EXPECT_EQ(fact(stereo_facts(scene.snapshot, shown_picture(scene.snapshot)), "Fill %")->left,
              "93")
        << "two seconds ago is now";
}

TEST(ShownPictures, WithDisparityAreTheLivePairThatWasMatchedLast) {
    auto scene = test::growing_scene(1, 2000);
    show_live(scene.snapshot);
    LiveStereo& live = scene.snapshot.live;
    auto plain = std::make_shared<StereoPicture>(*live.picture);
    plain->disparity = cv::Mat();
    live.picture = plain;
    EXPECT_EQ(shown_picture(scene.snapshot).picture, live.picture);
    EXPECT_TRUE(shown_picture(scene.snapshot).has_disparity);
    EXPECT_EQ(shown_picture(scene.snapshot, true).picture, live.matched);
    EXPECT_EQ(shown_picture(scene.snapshot, true).title, "live");
    live.matched.reset();
    EXPECT_EQ(shown_picture(scene.snapshot, true).picture, live.picture);
    EXPECT_FALSE(shown_picture(scene.snapshot, true).has_disparity);
}

TEST(ShownPictures, AreThoseOfTheSelectedStepWhileNotLive) {
    auto scene = test::growing_scene(3, 2000);
    for (auto& capture : scene.snapshot.captures) capture.picture = test::sample_picture();
    ShownPicture shown = shown_picture(scene.snapshot);
    EXPECT_EQ(shown.picture, scene.snapshot.captures[3].picture);
    EXPECT_EQ(shown.title, "capture 3");
    EXPECT_EQ(shown.why_not_live, "live images are off");
    scene.snapshot.follows_last = false;
    scene.snapshot.selected_row = 0;
    scene.snapshot.live.on = true;
    scene.snapshot.live.picture = test::sample_picture();
    shown = shown_picture(scene.snapshot);
    EXPECT_FALSE(shown.live);
    EXPECT_EQ(shown.picture, scene.snapshot.captures[1].picture);
    EXPECT_EQ(shown.why_not_live, "a step of Table 1 is selected");
    scene.snapshot.live.trouble = "the camera answers no more";
    EXPECT_EQ(shown_picture(scene.snapshot).why_not_live, "the camera answers no more");
}

TEST(AreaOutline, IsTheHullOfItsCornersAndShiftsByTheDisparity) {
    const auto scene = test::growing_scene(0, 2000);
    const auto left = area_outline_px(scene.snapshot.cell, Eye::kLeft);
    const auto right = area_outline_px(scene.snapshot.cell, Eye::kRight);
    // A box seen from the front shows its near face: that one hides the far one wholly.
    ASSERT_EQ(left.size(), 4U);
    const RectifiedRig& rig = *scene.snapshot.cell.rig;
    for (const Eigen::Vector2d& corner : left) {
        const Eigen::Vector2d shifted(corner.x() - rig.disparity_px(0.6), corner.y());
        const bool there = std::any_of(right.begin(), right.end(), [&](const Eigen::Vector2d& c) {
            return (c - shifted).norm() < 1e-9;
        });
        EXPECT_TRUE(there) << corner.transpose();
    }
    CellFrame behind = scene.snapshot.cell;
    behind.region->min_m.z() = -0.1;
    EXPECT_TRUE(area_outline_px(behind, Eye::kLeft).empty());
}

TEST(Disparity, IsReadInPixelsAndMillimetres) {
    const auto scene = test::growing_scene(0, 2000);
    const auto picture = test::sample_picture();
    const CellFrame& cell = scene.snapshot.cell;
    const double d = picture->disparity.at<float>(120, 160);
    EXPECT_EQ(disparity_text(*picture, cell, 160, 120), "160, 120: 62.40 px, 673.1 mm");
    EXPECT_NEAR(cell.rig->depth_m(d), 0.6731, 5e-5);
    EXPECT_EQ(disparity_text(*picture, cell, 3, 3), "3, 3: none");
    EXPECT_EQ(disparity_text(*picture, cell, -1, 3), "");
    const DisparityRange range = disparity_range(*picture, cell);
    EXPECT_EQ(range.far_mm, "800 mm");
    EXPECT_EQ(range.near_mm, "600 mm");
    EXPECT_EQ(row_text(120, 0.08), "row 120  Δy 0.08 px");
    EXPECT_EQ(row_text(120, std::nullopt), "row 120");
}

}  // namespace
}  // namespace gripscan::ui
