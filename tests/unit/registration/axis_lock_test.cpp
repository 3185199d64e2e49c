// A part that does not show its turn: rejected when measured freely, completed when locked to the
// axis, and told to be no measurement.
#include "core/registration/axis_lock.h"

#include "tests/unit/registration/solve_turn_case.h"

namespace gripscan {
namespace {

using namespace test;

TurnCase lathe_turn(std::uint64_t seed, int captures, double step_deg) {
    TurnCase turn{{}, {}, cell_axis(), part_of_revolution(seed, 0.0)};
    const ViewSettings settings{};
    for (int k = 0; k < captures; ++k) {
        const double angle_rad = rad_from_deg(k * step_deg);
        TurnView view;
        view.index = k;
        view.commanded_rad = angle_rad;
        view.joint6_rad = angle_rad;
        view.cloud = view_of(turn.part, part_turned(turn.axis, angle_rad), settings,
                             seed * 100 + static_cast<std::uint64_t>(k));
        view.cloud.intensity.clear();
        turn.T_view_first.push_back(turn_about(turn.axis, angle_rad));
        turn.views.push_back(std::move(view));
    }
    return turn;
}

void lock(std::vector<TurnView>& views) {
    for (TurnView& view : views) view.mode = TurnMode::kAxisLocked;
}

TurnSettings with_hint() {
    TurnSettings settings;
    settings.axis_hint = cell_axis().direction;
    settings.step_rad = rad_from_deg(20.0);
    return settings;
}

TEST(AxisLock, FreeStepsOfALathePartAreRejectedForSymmetry) {
    const TurnCase turn = lathe_turn(1, 4, 20.0);
    for (const TurnStep& step : solved(turn.views, with_hint()).steps) {
        EXPECT_EQ(word(step.verdict), "reject") << step.sentence;
        EXPECT_EQ(word(step.cause), "symmetry")
            << step.sentence << ", observability " << step.observability.value_or(-1.0);
    }
}

TEST(AxisLock, CompletesATurnFromTheNormalsAlone) {
    for (const std::uint64_t seed : {1U, 2U}) {
        TurnCase turn = lathe_turn(seed, 7, 20.0);
        lock(turn.views);
        const TurnReport report = solved(turn.views, with_hint());
        ASSERT_TRUE(report.axis);
        EXPECT_EQ(report.sign_source, SignSource::kAxisHint);
        EXPECT_GT(report.axis->axis.direction.dot(turn.axis.direction), 0.9999);
        for (const TurnStep& step : report.steps) {
            EXPECT_EQ(word(step.verdict), "check") << step.sentence;
            EXPECT_EQ(word(step.cause), "symmetry");
            EXPECT_EQ(step.mode, TurnMode::kAxisLocked);
            EXPECT_FALSE(step.independent);
            EXPECT_NEAR(deg_from_rad(*step.icp_rad), 20.0, 1e-9) << "the robot's, repeated";
            EXPECT_FALSE(step.error_rad) << "the robot's angle against itself";
        }
        const Eigen::Vector3d middle = centroid(turn.views[0].cloud);
        for (std::size_t k = 0; k < report.poses.size(); ++k) {
            ASSERT_TRUE(report.poses[k]);
            EXPECT_THAT(report.poses[k]->inverse(), IsPose(turn.T_view_first[k], middle, 0.3, 0.6));
        }
        EXPECT_GT(share_on_surface(report.merged, turn, 1.0e-3), 0.95);
    }
}

/// Reflections stand still while the part turns, and look like a texture that does not turn.
TEST(AxisLock, WhatStandsStillOnTheSurfaceDoesNotHoldTheViewsBack) {
    TurnCase turn = lathe_turn(6, 19, 20.0);
    lock(turn.views);
    for (TurnView& view : turn.views) {
        for (const Eigen::Vector3f& p : view.cloud.points) {
            const Eigen::Vector3f phase = 600.0F * p;
            view.cloud.intensity.push_back(
                120.0F + 40.0F * (std::sin(phase.x()) + std::sin(1.3F * phase.y())));
        }
    }
    const TurnReport report = solved(turn.views, with_hint());
    ASSERT_TRUE(report.axis);
    EXPECT_FALSE(report.angle_scale) << "nothing shows one";
    EXPECT_FALSE(report.closure_before) << "the robot's word is no closure";
    EXPECT_FALSE(report.closure_after);
    const Eigen::Vector3d middle = centroid(turn.views[0].cloud);
    for (std::size_t k = 0; k < report.poses.size(); ++k) {
        ASSERT_TRUE(report.poses[k]) << k;
        // The axis is what is left to be found; the angles are the robot's.
        EXPECT_THAT(report.poses[k]->inverse(), IsPose(turn.T_view_first[k], middle, 0.1, 0.3))
            << k;
    }
}

TEST(AxisLock, UsesTheAxisOfAWarmUp) {
    TurnCase turn = lathe_turn(3, 3, 20.0);
    lock(turn.views);
    TurnSettings settings = with_hint();
    settings.known_axis = AxisEstimate{turn.axis, 1e-3, 1e-4};
    const TurnReport report = solved(turn.views, settings);
    EXPECT_EQ(word(report.steps[0].verdict), "check") << report.steps[0].sentence;
}

/// The lock takes the robot's word for the angle, not for everything: a part that has moved aside
/// no longer fits.
TEST(AxisLock, RejectsAPartThatMovedAside) {
    TurnCase turn = lathe_turn(4, 6, 20.0);
    lock(turn.views);
    Pose aside = Pose::Identity();
    aside.translation() = Eigen::Vector3d(0.0, 3.0e-3, 2.0e-3);
    turn.views[3].cloud = transformed(turn.views[3].cloud, aside);
    turn.views[3].cloud.viewpoint = Eigen::Vector3f::Zero();
    const TurnReport report = solved(turn.views, with_hint());
    for (const std::size_t i : {2U, 3U}) {
        EXPECT_EQ(word(report.steps[i].verdict), "reject") << report.steps[i].sentence;
        EXPECT_EQ(word(report.steps[i].cause), "symmetry");
    }
    EXPECT_FALSE(report.poses[3]);
    EXPECT_TRUE(report.poses[5]) << "the views around it are bridged";
}

TEST(AxisLock, ALockedStepAmongFreeOnesUsesTheirAxis) {
    TurnCase turn = make_turn({.seed = 4, .captures = 5});
    turn.views[3].mode = TurnMode::kAxisLocked;
    const TurnReport report = solved(turn.views);
    EXPECT_EQ(word(report.steps[2].verdict), "check") << report.steps[2].sentence;
    EXPECT_EQ(word(report.steps[1].verdict), "accept") << report.steps[1].sentence;
    const Eigen::Vector3d middle = centroid(turn.views[0].cloud);
    for (std::size_t k = 0; k < report.poses.size(); ++k) {
        ASSERT_TRUE(report.poses[k]);
        EXPECT_THAT(report.poses[k]->inverse(), IsPose(turn.T_view_first[k], middle, 0.3, 0.6));
    }
}

TEST(AxisLock, WithoutAnAngleNothingCanBeLocked) {
    TurnCase turn = lathe_turn(5, 3, 20.0);
    lock(turn.views);
    for (TurnView& view : turn.views) {
        view.joint6_rad.reset();
        view.commanded_rad.reset();
    }
    const TurnReport report = solved(turn.views, with_hint());
    for (const TurnStep& step : report.steps) {
        EXPECT_EQ(word(step.verdict), "reject");
        EXPECT_THAT(step.sentence, testing::HasSubstr("by how much"));
    }
}

}  // namespace
}  // namespace gripscan
