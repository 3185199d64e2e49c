// The turn step by step is the turn at once: the same bytes, whatever was asked in between.
#include "core/procedure/turn_workspace.h"

#include <gmock/gmock.h>

#include "core/concurrency/worker_pool.h"
#include "tests/support/synthetic_turn.h"

namespace gripscan {
namespace {

using testing::HasSubstr;

std::vector<RecordedCapture> captures_of(const std::vector<Cloud>& views, double step_deg) {
    std::vector<RecordedCapture> captures;
    for (std::size_t k = 0; k < views.size(); ++k) {
        RecordedCapture capture;
        capture.index = static_cast<int>(k);
        capture.commanded_rad = rad_from_deg(static_cast<double>(k) * step_deg);
        capture.load_cloud = [cloud = views[k]]() -> Result<Cloud> { return cloud; };
        captures.push_back(std::move(capture));
    }
    return captures;
}

std::vector<RecordedCapture> small_turn(int captures = 4) {
    test::SyntheticTurnSettings settings;
    settings.samples = 9000;
    settings.captures = captures;
    return captures_of(test::synthetic_turn(settings), settings.step_deg);
}

TurnWorkspace empty_workspace() {
    auto workspace = TurnWorkspace::create(std::nullopt, std::nullopt, {});
    EXPECT_TRUE(workspace);
    return std::move(*workspace);
}

void expect_same(const TurnReport& a, const TurnReport& b) {
    ASSERT_EQ(a.steps.size(), b.steps.size());
    for (std::size_t i = 0; i < a.steps.size(); ++i) {
        EXPECT_EQ(a.steps[i].icp_rad, b.steps[i].icp_rad);
        EXPECT_EQ(a.steps[i].sentence, b.steps[i].sentence);
        ASSERT_EQ(a.steps[i].T.has_value(), b.steps[i].T.has_value());
        if (a.steps[i].T) {
            EXPECT_TRUE(a.steps[i].T->matrix() == b.steps[i].T->matrix());
        }
    }
    ASSERT_EQ(a.poses.size(), b.poses.size());
    for (std::size_t k = 0; k < a.poses.size(); ++k) {
        ASSERT_EQ(a.poses[k].has_value(), b.poses[k].has_value());
        if (a.poses[k]) {
            EXPECT_TRUE(a.poses[k]->matrix() == b.poses[k]->matrix());
        }
    }
    EXPECT_EQ(a.merged.points, b.merged.points);
    EXPECT_EQ(a.merged.sigma, b.merged.sigma);
    EXPECT_EQ(a.merged.seen, b.merged.seen);
}

TEST(TurnWorkspace, StepByStepGivesTheBytesOfAllAtOnce) {
    const auto captures = small_turn();
    WorkerPool pool(3);
    auto workspace = empty_workspace();
    for (std::size_t k = 0; k < captures.size(); ++k) {
        const auto added = workspace.add(captures[k], {}, pool.for_each());
        ASSERT_TRUE(added) << added.error().message;
        EXPECT_GT(added->points, 1000U);
        EXPECT_TRUE(added->flaw.empty());
        if (k == 0) continue;
        const auto step = workspace.last_step({captures.data(), k + 1}, {}, pool.for_each());
        ASSERT_TRUE(step) << step.error().message;
        EXPECT_EQ(step->step.index, static_cast<int>(k));
        EXPECT_EQ(step->step.verdict, Verdict::kAccept) << step->step.sentence;
        EXPECT_FALSE(step->lines.empty());
        if (k == 2) {
            ASSERT_TRUE(workspace.solve({captures.data(), k + 1}, {}, pool.for_each()));
        }
    }
    const auto grown = workspace.solve(captures, {}, pool.for_each());
    const auto at_once =
        compute_turn({std::nullopt, std::nullopt, captures}, {}, {}, for_each_in_order);
    ASSERT_TRUE(grown && at_once);
    expect_same(grown->report, at_once->report);
}

/// What was learned to stand still is gone before anything is registered, and nothing else.
TEST(TurnWorkspace, TakesTheLearnedEnvironmentAway) {
    Cloud cloud;
    cloud.points = small_turn(2).front().load_cloud().value().points;
    const std::size_t part = cloud.size();
    // A wall half a metre behind the part.
    std::vector<Eigen::Vector3f> wall(cloud.points.begin(), cloud.points.begin() + 400);
    for (Eigen::Vector3f& p : wall) p.z() += 0.5F;
    EnvironmentModel environment;
    environment.occupied = VoxelSet::of(0.008, wall, 1);
    cloud.points.insert(cloud.points.end(), wall.begin(), wall.end());
    RecordedCapture capture;
    capture.load_cloud = [cloud]() -> Result<Cloud> { return cloud; };
    ComputeTurnSettings settings;
    settings.environment = std::make_shared<const EnvironmentModel>(environment);
    const auto workspace = TurnWorkspace::create(std::nullopt, std::nullopt, settings);
    ASSERT_TRUE(workspace);
    const auto prepared = workspace->prepare(capture, {}, for_each_in_order);
    ASSERT_TRUE(prepared) << prepared.error().message;
    EXPECT_EQ(prepared->view.cloud.size(), part);
    const auto whole = empty_workspace().prepare(capture, {}, for_each_in_order);
    ASSERT_TRUE(whole);
    EXPECT_EQ(whole->view.cloud.size(), part + wall.size());
}

TEST(TurnWorkspace, ARetakenCaptureReplacesTheBadOne) {
    auto captures = small_turn(4);
    const auto good = captures;
    captures[2].load_cloud = captures[1].load_cloud;  // nothing turned
    auto workspace = empty_workspace();
    for (const auto& capture : captures) ASSERT_TRUE(workspace.add(capture, {}, for_each_in_order));
    const auto bad = workspace.last_step({captures.data(), 3}, {}, for_each_in_order);
    ASSERT_TRUE(bad);
    EXPECT_EQ(bad->step.verdict, Verdict::kReject);
    ASSERT_TRUE(workspace.add(good[2], {}, for_each_in_order));
    const auto solved = workspace.solve(good, {}, for_each_in_order);
    const auto at_once =
        compute_turn({std::nullopt, std::nullopt, good}, {}, {}, for_each_in_order);
    ASSERT_TRUE(solved && at_once);
    expect_same(solved->report, at_once->report);
}

TEST(TurnWorkspace, UnusedCapturesStayOutAndKeepTheirPlace) {
    auto captures = small_turn(5);
    auto workspace = empty_workspace();
    for (const auto& capture : captures) ASSERT_TRUE(workspace.add(capture, {}, for_each_in_order));
    captures[2].used = false;
    const auto solved = workspace.solve(captures, {}, for_each_in_order);
    ASSERT_TRUE(solved);
    ASSERT_EQ(solved->report.poses.size(), 5U);
    EXPECT_FALSE(solved->report.poses[2]);
    EXPECT_EQ(solved->report.steps[1].from, 1);
    EXPECT_EQ(solved->report.steps[1].to, 3);
    captures[2].used = true;
    const auto again = workspace.solve(captures, {}, for_each_in_order);
    ASSERT_TRUE(again);
    EXPECT_TRUE(again->report.poses[2]) << "nothing was dropped";
}

TEST(TurnWorkspace, NoteAndModeReachTheRows) {
    auto captures = small_turn(4);
    *captures[3].commanded_rad += rad_from_deg(0.8);
    captures[3].note = "the pendant was read late";
    captures[2].mode = TurnMode::kAxisLocked;
    const auto computed =
        compute_turn({std::nullopt, std::nullopt, captures}, {}, {}, for_each_in_order);
    ASSERT_TRUE(computed) << computed.error().message;
    EXPECT_EQ(computed->report.steps[2].verdict, Verdict::kAcceptNoted);
    EXPECT_THAT(computed->report.steps[2].sentence, HasSubstr("read late"));
    EXPECT_EQ(computed->report.steps[1].mode, TurnMode::kAxisLocked);
    EXPECT_FALSE(computed->report.steps[1].independent);
}

TEST(TurnWorkspace, NamesTheCaptureThatWasNotAdded) {
    const auto captures = small_turn(4);
    auto workspace = empty_workspace();
    for (const auto& capture : captures) ASSERT_TRUE(workspace.add(capture, {}, for_each_in_order));
    workspace.forget(2);
    EXPECT_EQ(workspace.view(2), nullptr);
    EXPECT_NE(workspace.view(1), nullptr);
    const auto solved = workspace.solve(captures, {}, for_each_in_order);
    ASSERT_FALSE(solved);
    EXPECT_THAT(solved.error().message, HasSubstr("capture 2"));
    EXPECT_FALSE(workspace.last_step({captures.data(), 1}, {}, for_each_in_order));
}

/// One step has no other to compare its axis with; a warm-up has.
TEST(TurnWorkspace, TheFirstStepIsHeldAgainstTheAxisOfTheWarmUp) {
    const auto captures = small_turn(2);
    auto workspace = empty_workspace();
    for (const auto& capture : captures) ASSERT_TRUE(workspace.add(capture, {}, for_each_in_order));
    const auto alone = workspace.last_step(captures, {}, for_each_in_order);
    ASSERT_TRUE(alone);
    EXPECT_NEAR(*alone->step.tilt_rad, 0.0, 1e-9);
    Axis axis = test::synthetic_axis();
    axis.direction = (axis.direction + Eigen::Vector3d(0, 0.1, 0)).normalized();
    workspace.set_known_axis(AxisEstimate{axis, 1e-3, 1e-4});
    const auto held = workspace.last_step(captures, {}, for_each_in_order);
    ASSERT_TRUE(held);
    EXPECT_GT(deg_from_rad(*held->step.tilt_rad), 4.0);
}

}  // namespace
}  // namespace gripscan
