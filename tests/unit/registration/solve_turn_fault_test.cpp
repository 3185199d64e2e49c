// Turns with one thing wrong: the right capture is named, the others stay trusted, and the template
// stays clean.
#include <gtest/gtest.h>

#include <set>

#include "tests/unit/registration/solve_turn_case.h"

namespace gripscan {
namespace {

using namespace test;

std::set<int> rejected(const TurnReport& report) {
    std::set<int> steps;
    for (const TurnStep& step : report.steps) {
        if (step.verdict == Verdict::kReject) steps.insert(step.index);
    }
    return steps;
}

std::set<int> unmerged(const TurnReport& report) {
    std::set<int> views;
    for (std::size_t k = 0; k < report.poses.size(); ++k) {
        if (!report.poses[k]) views.insert(static_cast<int>(k));
    }
    return views;
}

void expect_clean(const TurnReport& report, const TurnCase& turn) {
    EXPECT_GT(report.merged.size(), 3000U);
    EXPECT_GT(share_on_surface(report.merged, turn, 1.0e-3), 0.95);
    const Eigen::Vector3d middle = centroid(turn.views[0].cloud);
    for (std::size_t k = 0; k < report.poses.size(); ++k) {
        if (!report.poses[k]) continue;
        EXPECT_THAT(report.poses[k]->inverse(), IsPose(turn.T_view_first[k], middle, 0.3, 0.6))
            << "view " << k;
    }
}

/// Ten captures, 10 degrees apart.
TurnPlan ten_captures() {
    return {.seed = 4, .captures = 10};
}

TEST(FaultyTurn, CaptureMislabelledByAStep) {
    TurnCase turn = make_turn(ten_captures());
    turn.views[5].cloud = turn.views[6].cloud;  // seen a step too late
    const TurnReport report = solved(turn.views);
    EXPECT_EQ(rejected(report), (std::set<int>{5, 6}));
    EXPECT_EQ(unmerged(report), std::set<int>{5});
    for (const int step : {5, 6}) {
        const TurnStep& row = report.steps[static_cast<std::size_t>(step - 1)];
        EXPECT_EQ(word(row.cause), "mislabelled") << row.sentence;
        EXPECT_THAT(row.sentence, testing::HasSubstr("capture 5 does not fit"));
    }
    expect_clean(report, turn);
}

TEST(FaultyTurn, AngleMislabelledByAStep) {
    TurnCase turn = make_turn(ten_captures());
    *turn.views[4].joint6_rad += rad_from_deg(10.0);
    *turn.views[4].commanded_rad += rad_from_deg(10.0);
    const TurnReport report = solved(turn.views);
    EXPECT_EQ(rejected(report), (std::set<int>{4, 5}));
    EXPECT_EQ(unmerged(report), std::set<int>{4});
    expect_clean(report, turn);
}

TEST(FaultyTurn, TwoCapturesSwapped) {
    TurnCase turn = make_turn(ten_captures());
    std::swap(turn.views[4].cloud, turn.views[5].cloud);
    const TurnReport report = solved(turn.views);
    const auto steps = rejected(report);
    EXPECT_TRUE(steps.contains(4) && steps.contains(5) && steps.contains(6));
    EXPECT_EQ(steps.size(), 3U);
    // Either of the two may be the one that is dropped, with its neighbour or without.
    const auto dropped = unmerged(report);
    EXPECT_TRUE(dropped.contains(4) || dropped.contains(5));
    EXPECT_LE(dropped.size(), 2U);
    expect_clean(report, turn);
}

TEST(FaultyTurn, CaptureMissingWithItsAngleIsOneLargerStep) {
    TurnCase turn = make_turn(ten_captures());
    turn.views.erase(turn.views.begin() + 3);
    turn.T_view_first.erase(turn.T_view_first.begin() + 3);
    const TurnReport report = solved(turn.views);
    EXPECT_TRUE(all_trusted(report));
    EXPECT_EQ(report.steps[2].from, 2);
    EXPECT_EQ(report.steps[2].to, 4);
    EXPECT_NEAR(deg_from_rad(*report.steps[2].icp_rad), 20.0, 0.5);
    expect_clean(report, turn);
}

TEST(FaultyTurn, PartSlipsAlongTheAxis) {
    TurnPlan plan = ten_captures();
    plan.slips_before = 3;
    const TurnCase turn = make_turn(plan);
    const TurnReport report = solved(turn.views);
    EXPECT_EQ(rejected(report), std::set<int>{3});
    EXPECT_EQ(word(report.steps[2].cause), "slip") << report.steps[2].sentence;
    EXPECT_NEAR(kMmPerM * *report.steps[2].slip_m, 3.0, 0.3);
    // The longer part of the turn makes the template.
    EXPECT_EQ(unmerged(report), (std::set<int>{0, 1, 2}));
}

TEST(FaultyTurn, GearRatioIsNamed) {
    TurnPlan plan = ten_captures();
    plan.true_over_robot = 0.8;
    for (const TurnStep& step : solved(make_turn(plan).views).steps) {
        EXPECT_EQ(step.verdict, Verdict::kReject) << step.sentence;
        EXPECT_EQ(word(step.cause), "ratio") << step.sentence;
    }
}

TEST(FaultyTurn, OperatorsNoteOverrules) {
    TurnCase turn = make_turn({.seed = 4, .captures = 5});
    *turn.views[4].joint6_rad += rad_from_deg(0.8);
    turn.views[4].note = "encoder was read late";
    const TurnReport report = solved(turn.views);
    EXPECT_EQ(report.steps[3].verdict, Verdict::kAcceptNoted);
    EXPECT_THAT(report.steps[3].sentence, testing::HasSubstr("encoder was read late"));
    EXPECT_TRUE(all_trusted(report));
}

TEST(FaultyTurn, AViewWithoutPointsCostsItsStepsAlone) {
    TurnCase turn = make_turn({.seed = 4, .captures = 5});
    turn.views[2].cloud = Cloud{};
    const TurnReport report = solved(turn.views);
    ASSERT_EQ(report.steps.size(), 4u);
    for (const std::size_t i : {1u, 2u}) {
        EXPECT_EQ(report.steps[i].verdict, Verdict::kReject);
        EXPECT_EQ(word(report.steps[i].cause), "texture");
        EXPECT_FALSE(report.steps[i].icp_rad);
        EXPECT_THAT(report.steps[i].sentence,
                    testing::HasSubstr(fmt::format("capture {}", turn.views[2].index)));
    }
    EXPECT_EQ(report.steps[0].verdict, Verdict::kAccept) << report.steps[0].sentence;
    EXPECT_EQ(report.steps[3].verdict, Verdict::kAccept) << report.steps[3].sentence;
    EXPECT_FALSE(report.poses[2]);
    EXPECT_TRUE(report.poses[4]) << "the views around it are bridged";
}

TEST(FaultyTurn, UnusableInputIsAnErrorThatNamesACapture) {
    TurnCase turn = make_turn({.seed = 4, .captures = 3});
    turn.views[0].index = 17;
    turn.views[0].cloud = turn.views[1].cloud = Cloud{};
    const auto empty = solve_turn(turn.views, {}, {}, for_each_in_order);
    ASSERT_FALSE(empty);
    EXPECT_THAT(empty.error().message, testing::HasSubstr("capture 17"));
    turn.views.resize(1);
    EXPECT_FALSE(solve_turn(turn.views, {}, {}, for_each_in_order));
    EXPECT_FALSE(solve_turn({}, {}, {}, for_each_in_order));
}

TEST(FaultyTurn, IsCancelled) {
    const TurnCase turn = make_turn({.seed = 4, .captures = 3});
    std::stop_source stop;
    stop.request_stop();
    const auto result = solve_turn(turn.views, {}, {stop.get_token(), {}}, for_each_in_order);
    ASSERT_FALSE(result);
    EXPECT_EQ(result.error().kind, ErrorKind::kCancelled);
}

TEST(Turn, NumberOfThreadsDoesNotMatter) {
    const TurnCase turn = make_turn({.seed = 9, .captures = 6});
    const auto alone = solve_turn(turn.views, {}, {}, for_each_in_order);
    WorkerPool pool(3);
    const auto threaded = solve_turn(turn.views, {}, {}, pool.for_each());
    ASSERT_TRUE(alone && threaded);
    for (std::size_t k = 0; k < alone->poses.size(); ++k) {
        ASSERT_TRUE(alone->poses[k] && threaded->poses[k]);
        EXPECT_TRUE(alone->poses[k]->matrix() == threaded->poses[k]->matrix());
    }
    EXPECT_EQ(alone->merged.points, threaded->merged.points);
    EXPECT_EQ(alone->merged.normals, threaded->merged.normals);
    EXPECT_EQ(alone->merged.sigma, threaded->merged.sigma);
    EXPECT_EQ(alone->merged.seen, threaded->merged.seen);
}

}  // namespace
}  // namespace gripscan
