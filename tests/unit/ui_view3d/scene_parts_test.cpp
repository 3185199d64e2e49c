#include "ui/views/scene_parts.h"

#include <gtest/gtest.h>

#include "core/base/units.h"
#include "tests/support/sample_scene.h"
#include "ui/theme/shown_number.h"
#include "ui/views/colouring_text.h"
#include "ui/views/scene_words.h"

namespace gripscan::ui {
namespace {

using test::growing_scene;
using test::rejected_scene;
using test::template_scene;

std::vector<const SceneCloud*> visible(const SceneParts& parts) {
    std::vector<const SceneCloud*> clouds;
    for (const SceneCloud& cloud : parts.clouds) {
        if (cloud.visible) clouds.push_back(&cloud);
    }
    return clouds;
}

TEST(SceneParts, OfTheGrowingCloudAreTurnedBackToTheFirstView) {
    const auto scene = growing_scene(4, 4000);
    const SceneParts parts = scene_parts(scene.snapshot, {});
    EXPECT_EQ(parts.kind, SceneKind::kGrowing);
    ASSERT_EQ(parts.clouds.size(), 5U);
    for (int i = 0; i < 5; ++i) {
        const auto& cloud = parts.clouds[static_cast<std::size_t>(i)];
        EXPECT_EQ(cloud.step, i);
        // The captures were turned by i steps; composed steps have to turn them back.
        const Pose expected = turn_about(test::scene_axis(), -i * 10.0 * kRadPerDeg);
        EXPECT_TRUE(cloud.T_first_cloud.isApprox(expected, 1e-9)) << i;
    }
    EXPECT_EQ(parts.steps_done, 4);
    EXPECT_EQ(parts.steps_total, 36);
    EXPECT_NEAR(parts.turn.turned_rad, 40.0 * kRadPerDeg, 1e-12);
    EXPECT_NEAR(parts.turn.next_rad.value(), 50.0 * kRadPerDeg, 1e-12);
}

TEST(SceneParts, TakeThePosesOfTheSolutionOnceThereIsOne) {
    auto scene = growing_scene(2, 2000);
    auto solved = std::make_shared<ComputedTurn>();
    solved->report.poses = {Pose::Identity(), std::nullopt,
                            Pose(Eigen::Translation3d(1.0, 2.0, 3.0))};
    scene.snapshot.solved = solved;
    const SceneParts parts = scene_parts(scene.snapshot, {});
    ASSERT_EQ(parts.clouds.size(), 3U);
    EXPECT_FALSE(parts.clouds[1].visible) << "a view that was not merged has no place";
    EXPECT_EQ(parts.not_placed, 1);
    EXPECT_EQ(parts.clouds[2].T_first_cloud.translation(), Eigen::Vector3d(1.0, 2.0, 3.0));

    // A solution of other captures says nothing about these.
    solved->report.poses.pop_back();
    EXPECT_TRUE(scene_parts(scene.snapshot, {}).clouds[1].visible);
}

TEST(SceneParts, OfARejectedStepAreItsTwoClouds) {
    auto scene = rejected_scene(6, 0.25, 4000);
    const SceneParts parts = scene_parts(scene.snapshot, {});
    EXPECT_EQ(parts.kind, SceneKind::kPair);
    const auto clouds = visible(parts);
    ASSERT_EQ(clouds.size(), 2U);
    EXPECT_EQ(clouds[0]->role, CloudRole::kTarget);
    EXPECT_EQ(clouds[1]->role, CloudRole::kSource);
    EXPECT_EQ(parts.pair_from, 5);
    EXPECT_EQ(parts.pair_to, 6);
    EXPECT_NEAR(parts.turn.turned_rad, 50.0 * kRadPerDeg, 1e-12);
    EXPECT_NEAR(parts.turn.robot_rad.value(), 60.0 * kRadPerDeg, 1e-12);
    EXPECT_NEAR(parts.turn.icp_rad.value(), 60.0 * kRadPerDeg + 0.25, 1e-12);
    EXPECT_FALSE(parts.turn.next_rad) << "there is no next step before this one is decided";
}

TEST(SceneParts, TheSecondCloudOfAStepStandsAsWished) {
    const auto scene = rejected_scene(2, 0.25, 2000);
    const auto T_of = [&](PairPose pose) {
        return visible(scene_parts(scene.snapshot, {true, pose})).at(1)->T_first_cloud;
    };
    const Axis axis = test::scene_axis();
    EXPECT_TRUE(T_of(PairPose::kBefore).isApprox(Pose::Identity()));
    EXPECT_TRUE(
        T_of(PairPose::kAligned).isApprox(turn_about(axis, -(10.0 * kRadPerDeg + 0.25)), 1e-9));
    EXPECT_TRUE(T_of(PairPose::kRobot).isApprox(turn_about(axis, -10.0 * kRadPerDeg), 1e-9));
}

TEST(SceneParts, SayWhyACloudCannotStandAsWished) {
    auto scene = rejected_scene(2, 0.25, 2000);
    scene.state->judged[{1, 2}].row.T.reset();
    scene.snapshot.cell.axis.reset();
    const SceneParts parts = scene_parts(scene.snapshot, {});
    EXPECT_EQ(parts.why_no_aligned, "the registration found no pose");
    EXPECT_EQ(parts.why_no_robot, "the axis is not known yet");
}

TEST(SceneParts, AfterARejectedStepNothingHasAPlace) {
    auto scene = rejected_scene(3, 0.25, 2000);
    const SceneParts parts = scene_parts(scene.snapshot, {false, PairPose::kAligned});
    EXPECT_EQ(parts.kind, SceneKind::kGrowing);
    EXPECT_EQ(visible(parts).size(), 3U);
    EXPECT_EQ(parts.not_placed, 1);
    EXPECT_EQ(parts.steps_done, 2);
}

TEST(SceneParts, AChosenRowOfTable1ShowsItsClouds) {
    auto scene = growing_scene(5, 2000);
    scene.snapshot.follows_last = false;
    scene.snapshot.selected_row = 1;
    const SceneParts parts = scene_parts(scene.snapshot, {});
    EXPECT_EQ(parts.kind, SceneKind::kPair);
    EXPECT_EQ(parts.pair_from, 1);
    EXPECT_EQ(parts.pair_to, 2);
    EXPECT_EQ(scene_parts(scene.snapshot, {false, {}}).kind, SceneKind::kGrowing);
}

TEST(SceneParts, TwoCloudsThatAreNotHereCannotBeShown) {
    auto scene = growing_scene(1, 2000);
    EXPECT_EQ(why_no_pair(scene.snapshot), "");
    scene.snapshot.captures.pop_back();
    EXPECT_EQ(why_no_pair(scene.snapshot), "the clouds of step 1 are not here");
    EXPECT_EQ(scene_parts(scene.snapshot, {true, {}}).kind, SceneKind::kGrowing);
    scene.state->judged.clear();
    EXPECT_EQ(why_no_pair(scene.snapshot), "no step has been judged yet");
}

TEST(SceneParts, OfTheTemplatePageAreTheMergedCloud) {
    auto scene = template_scene(5000);
    const SceneParts parts = scene_parts(scene.snapshot, {});
    EXPECT_EQ(parts.kind, SceneKind::kTemplate);
    const auto clouds = visible(parts);
    ASSERT_EQ(clouds.size(), 1U);
    EXPECT_EQ(clouds[0]->cloud.get(), &scene.snapshot.solved->report.merged);
    EXPECT_EQ(visible_points(parts), 5000U);
    EXPECT_FALSE(parts.turn.next_rad) << "the turn is complete";
}

TEST(SceneWords, SayWhatToDoWhileThereIsNoCloud) {
    auto scene = test::empty_scene();
    EXPECT_EQ(scene_parts(scene.snapshot, {}).kind, SceneKind::kEmpty);
    EXPECT_EQ(empty_scene_text(scene.snapshot).what_to_do,
              "Connect, check the cell, take the first view.");
    scene.state->phase = phase::Idle{};
    EXPECT_EQ(empty_scene_text(scene.snapshot).what_to_do,
              "Check the cell, then take the first view.");
    scene.state->cell = CellReport{};
    EXPECT_EQ(empty_scene_text(scene.snapshot).what_to_do, "Take the first view.");
    EXPECT_EQ(empty_scene_text(Snapshot{}).title, "No session is open");
}

TEST(SceneWords, NameStepAngleAndPointsBelowAPicture) {
    const auto scene = growing_scene(4, 36000);
    const SceneParts parts = scene_parts(scene.snapshot, {});
    EXPECT_EQ(scene_caption(scene.snapshot, parts),
              "valve-T20, step 4 of 36, 40.0°, " +
                  shown_count(static_cast<long long>(visible_points(parts))) + " points");
}

TEST(Colourings, ThatAreNotToBeHadSayWhy) {
    const auto scene = growing_scene(2, 2000);
    const SceneParts parts = scene_parts(scene.snapshot, {});
    EXPECT_EQ(why_no_colouring(ColourBy::kStep, parts), "");
    EXPECT_EQ(why_no_colouring(ColourBy::kImage, parts), "");
    EXPECT_NE(why_no_colouring(ColourBy::kSeen, parts), "");
    EXPECT_EQ(why_no_colouring(ColourBy::kResidual, parts), "");
    const auto alone = growing_scene(0, 2000);
    EXPECT_NE(why_no_colouring(ColourBy::kResidual, scene_parts(alone.snapshot, {})), "");
    const auto merged = template_scene(2000);
    const SceneParts whole = scene_parts(merged.snapshot, {});
    EXPECT_EQ(why_no_colouring(ColourBy::kSeen, whole), "");
    EXPECT_NE(why_no_colouring(ColourBy::kStep, whole), "");
    EXPECT_EQ(usual_colouring(whole), ColourBy::kSeen);
}

TEST(Colourings, TakeTheirRangeFromThePoints) {
    const auto merged = template_scene(8000);
    const SceneParts parts = scene_parts(merged.snapshot, {});
    // The part is 70 mm thick about a depth of 700 mm; its legs are thinner.
    const LegendRange depth = usual_range(ColourBy::kDepth, parts, 1);
    EXPECT_NEAR(depth.from, 735.0, 3.0);
    EXPECT_NEAR(depth.to, 665.0, 3.0);
    const LegendRange seen = usual_range(ColourBy::kSeen, parts, 4);
    EXPECT_EQ(seen.from, 4.0);
    EXPECT_NEAR(seen.to, 24.0, 2.0);  // 1 + 240 per metre over 0.1 m
    EXPECT_EQ(usual_range(ColourBy::kStep, parts, 1).to, 36.0);
}

}  // namespace
}  // namespace gripscan::ui
