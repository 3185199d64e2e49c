// All captures of a closing turn at once: poses, the robot's scale, and what is claimed of them.
#include "core/registration/joint_solution.h"

#include <gtest/gtest.h>

#include "tests/unit/registration/solve_turn_case.h"

namespace gripscan {
namespace {

using namespace test;

struct Solved {
    TurnCase turn;
    JointSolution solution;
};

/// 24 captures of 15 degrees and the closing one; the robot reports angle / ratio with noise.
Solved solve(std::uint64_t seed, double ratio, double robot_noise_deg) {
    TurnPlan plan{.seed = seed, .captures = 25, .step_deg = 15.0 / ratio};
    plan.robot_noise_deg = robot_noise_deg;
    plan.true_over_robot = ratio;
    Solved result{make_turn(plan), {}};
    std::vector<Surface> surfaces;
    for (const TurnView& view : result.turn.views) {
        surfaces.push_back(std::move(*make_surface(view.cloud)));
    }
    std::vector<JointView> views;
    for (std::size_t k = 0; k < surfaces.size(); ++k) {
        views.push_back({&surfaces[k],
                         *result.turn.views[k].joint6_rad - *result.turn.views[0].joint6_rad,
                         rad_from_deg(std::max(0.005, robot_noise_deg))});
    }
    // The axis as the steps would give it: a little off.
    Axis start = result.turn.axis;
    start.point_m += Eigen::Vector3d(0.0, 2e-4, -2e-4);
    start.direction = (start.direction + Eigen::Vector3d(0.0, 1e-3, 1e-3)).normalized();
    WorkerPool pool(2);
    auto solution = solve_jointly(views, start, {}, {}, pool.for_each());
    EXPECT_TRUE(solution);
    result.solution = std::move(*solution);
    return result;
}

PoseError worst_pose(const Solved& s) {
    const Eigen::Vector3d middle = centroid(s.turn.views[0].cloud);
    PoseError worst;
    for (std::size_t k = 0; k < s.turn.views.size(); ++k) {
        const PoseError e = pose_error(s.solution.T_view_first[k], s.turn.T_view_first[k], middle);
        worst = {std::max(worst.deg, e.deg), std::max(worst.mm, e.mm)};
    }
    return worst;
}

TEST(SolveJointly, ExactAnglesGiveExactPoses) {
    const Solved s = solve(2, 1.0, 0.0);
    EXPECT_FALSE(s.solution.scale_estimated) << s.solution.scale;
    EXPECT_EQ(s.solution.T_view_first.size(), 25U);
    EXPECT_TRUE(s.solution.T_view_first[0].matrix().isIdentity(1e-12));
    const PoseError worst = worst_pose(s);
    // Angles given to 0.005 degrees, the arm's wobble of 2e-4 rad = 0.011 degrees: four times.
    EXPECT_LT(worst.deg, 0.05);
    EXPECT_LT(worst.mm, 0.15);
    EXPECT_LT(s.turn.axis.distance_m(s.solution.axis.axis.point_m), 0.15e-3);
    EXPECT_GT(s.solution.axis.sd_rad, 0.0);
}

TEST(SolveJointly, NoisyAnglesCostAboutTheirNoise) {
    for (const std::uint64_t seed : {2, 3}) {
        const Solved s = solve(seed, 1.0, 0.02);
        EXPECT_FALSE(s.solution.scale_estimated) << s.solution.scale;
        // The first reading's error is shared by all views; 0.02·√2, the largest of 24 of them.
        EXPECT_LT(worst_pose(s).deg, 0.1) << seed;
        EXPECT_LT(worst_pose(s).mm, 0.2) << seed;
    }
}

TEST(SolveJointly, AWrongRatioIsFound) {
    for (const double ratio : {0.98, 1.02}) {
        const Solved s = solve(4, ratio, 0.01);
        EXPECT_TRUE(s.solution.scale_estimated);
        EXPECT_NEAR(s.solution.scale, ratio, std::max(4.0 * s.solution.scale_sigma, 2e-3));
        EXPECT_LT(worst_pose(s).deg, 0.3) << ratio;
    }
}

TEST(SolveJointly, ATinyRatioIsEstimatedOrHarmless) {
    const Solved s = solve(5, 1.001, 0.01);
    if (s.solution.scale_estimated) {
        EXPECT_NEAR(s.solution.scale, 1.001, 1e-3);
    } else {
        EXPECT_EQ(s.solution.scale, 1.0);
    }
    // Unestimated, 0.1 % of a whole turn is 0.36 degrees between the ends.
    EXPECT_LT(worst_pose(s).deg, 0.4);
}

TEST(SolveJointly, IsCancelled) {
    const TurnCase turn = make_turn({.seed = 1, .captures = 3});
    std::vector<Surface> surfaces;
    for (const TurnView& view : turn.views)
        surfaces.push_back(std::move(*make_surface(view.cloud)));
    std::vector<JointView> views;
    for (const Surface& s : surfaces)
        views.push_back({&s, 0.17 * static_cast<double>(views.size()), 1e-3});
    std::stop_source stop;
    stop.request_stop();
    const auto result =
        solve_jointly(views, turn.axis, {}, {stop.get_token(), {}}, for_each_in_order);
    ASSERT_FALSE(result);
    EXPECT_EQ(result.error().kind, ErrorKind::kCancelled);
}

}  // namespace
}  // namespace gripscan
