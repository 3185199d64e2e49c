// The linear system of the joint solution: its laws against finite motions, and a perturbed turn
// brought back.
#include "core/registration/joint_system.h"

#include <gtest/gtest.h>

#include "core/base/units.h"
#include "tests/support/pose_matchers.h"
#include "tests/support/random_pose.h"

namespace gripscan {
namespace {

using namespace test;

Vector6d small_motion(SeededRandom& random, double size) {
    Vector6d u;
    u << size * random_direction(random), size * random_direction(random);
    return u;
}

TEST(AdjointAbout, CarriesMotionsThroughATurn) {
    SeededRandom random(1);
    for (int i = 0; i < 50; ++i) {
        const Pose T = random_pose(random, 3.0);
        const Eigen::Vector3d centre = random_pose(random, 0.0).translation();
        const Vector6d u = small_motion(random, 1e-5);
        const Pose left = T * motion_about(u, centre);
        const Pose right = motion_about(adjoint_about(T, centre) * u, centre) * T;
        EXPECT_LT((left.matrix() - right.matrix()).norm(), 1e-9);
    }
}

TEST(MotionOf, UndoesMotionAbout) {
    SeededRandom random(2);
    for (int i = 0; i < 50; ++i) {
        const Eigen::Vector3d centre = random_pose(random, 0.0).translation();
        const Vector6d u = small_motion(random, 0.5);
        EXPECT_LT((motion_of(motion_about(u, centre), centre) - u).norm(), 1e-12);
    }
}

/// A turn whose pairs and robot readings are exact, in a system that starts beside the truth.
struct Truth {
    Axis axis{Eigen::Vector3d(0.01, -0.02, 0.6), Eigen::Vector3d(1.0, 0.1, -0.1).normalized()};
    Eigen::Vector3d centre{0.02, -0.01, 0.61};
    double scale = 1.001;
    double offset_rad = 2e-4;
    double scan_scale = 1.0;
    std::size_t views = 12;
    [[nodiscard]] double reported_rad(std::size_t k) const {
        return rad_from_deg(30.0) * static_cast<double>(k);
    }
    [[nodiscard]] Pose pose(std::size_t k) const {
        return turn_about(axis, k == 0 ? 0.0 : scale * reported_rad(k) + offset_rad);
    }
};

/// What a pair would measure: H of a well-shaped part, g of the deviation from the true pose.
NormalEquations measured(const Pose& T_now, const Pose& T_true, const Eigen::Vector3d& centre) {
    NormalEquations sums;
    sums.H.diagonal() << 4e6, 5e6, 6e6, 2e9, 3e9, 4e9;
    sums.H(0, 4) = sums.H(4, 0) = 3e7;
    sums.g = sums.H * motion_of(T_now * T_true.inverse(), centre);
    return sums;
}

struct State {
    Axis axis;
    std::vector<Pose> poses;
    double scale = 1.0;
    double offset_rad = 0.0;
};

void improve(const Truth& truth, State& state) {
    JointSystem system(truth.views, state.axis, truth.centre);
    for (std::size_t i = 0; i < truth.views; ++i) {
        const std::size_t j = (i + 1) % truth.views;
        const Pose now = state.poses[j] * state.poses[i].inverse();
        const Pose wanted = truth.pose(j) * truth.pose(i).inverse();
        system.add_pair(i, j, now, rad_from_deg(30.0), 1.0, measured(now, wanted, truth.centre),
                        1.0);
    }
    for (std::size_t k = 1; k < truth.views; ++k) {
        system.add_prior(k, state.poses[k], state.scale, state.offset_rad,
                         {truth.reported_rad(k), 3e-4, 2e-4, 3e-5});
    }
    // Next to no pull on scale and offset; the scans' own scale is held.
    system.add_global_prior(JointSystem::kRobotScale, 0.0, 10.0);
    system.add_global_prior(JointSystem::kRobotOffset, 0.0, 10.0);
    system.add_global_prior(JointSystem::kScanScale, 0.0, 1e-9);
    ASSERT_TRUE(system.solve());
    for (std::size_t k = 0; k < truth.views; ++k) {
        state.poses[k] = system.correction(k) * state.poses[k];
    }
    state.axis = system.corrected_axis();
    state.scale += system.global_corrections()(JointSystem::kRobotScale);
    state.offset_rad += system.global_corrections()(JointSystem::kRobotOffset);
}

TEST(JointSystem, BringsAPerturbedTurnBack) {
    const Truth truth;
    for (std::uint64_t seed = 1; seed <= 5; ++seed) {
        SeededRandom random(seed);
        State state;
        const Pose off = motion_about(small_motion(random, 2e-3), truth.centre);
        state.axis = {off * truth.axis.point_m, off.linear() * truth.axis.direction};
        for (std::size_t k = 0; k < truth.views; ++k) {
            const Vector6d u = k == 0 ? Vector6d(Vector6d::Zero()) : small_motion(random, 2e-3);
            state.poses.push_back(motion_about(u, truth.centre) * truth.pose(k));
        }
        for (int step = 0; step < 6; ++step) improve(truth, state);
        for (std::size_t k = 0; k < truth.views; ++k) {
            EXPECT_THAT(state.poses[k], IsPose(truth.pose(k), truth.centre, 1e-4, 1e-4)) << k;
        }
        EXPECT_NEAR(state.scale, truth.scale, 1e-6);
        EXPECT_NEAR(state.offset_rad, truth.offset_rad, 1e-6);
        EXPECT_LT(truth.axis.distance_m(state.axis.point_m), 1e-6);
        EXPECT_GT(state.axis.direction.dot(truth.axis.direction), 1.0 - 1e-10);
    }
}

/// With the robot alone, the correction of a view must be the finite motion onto the model turn:
/// the prior's linearisation against the thing itself, for each global in turn.
TEST(JointSystem, PriorAnswersToTheGlobalsAsTheModelDoes) {
    const Truth truth;
    constexpr double kStep = 1e-5;
    const Eigen::Vector3d across = truth.axis.direction.unitOrthogonal();
    const Eigen::Vector3d other = truth.axis.direction.cross(across);
    const auto tilted = [&](const Eigen::Vector3d& w, const Eigen::Vector3d& v) {
        Vector6d u;
        u << w, v;
        const Pose M = motion_about(u, truth.centre);
        return Axis{M * truth.axis.point_m, M.linear() * truth.axis.direction};
    };
    const Eigen::Vector3d zero = Eigen::Vector3d::Zero();
    struct Moved {
        Axis axis;
        double scale = 1.0;
        double offset_rad = 0.0;
    };
    const std::array<Moved, 6> truths{
        Moved{tilted(kStep * across, zero)}, Moved{tilted(kStep * other, zero)},
        Moved{tilted(zero, kStep * across)}, Moved{tilted(zero, kStep * other)},
        Moved{truth.axis, 1.0 + kStep, 0.0}, Moved{truth.axis, 1.0, kStep}};
    for (std::size_t g = 0; g < truths.size(); ++g) {
        JointSystem system(4, truth.axis, truth.centre);
        for (std::size_t k = 1; k < 4; ++k) {
            const double angle = 0.7 * static_cast<double>(k);
            const Pose held =
                turn_about(truths[g].axis, truths[g].scale * angle + truths[g].offset_rad);
            // The view is nailed down, so only the globals can explain it.
            NormalEquations nail;
            nail.H = 1e16 * Matrix6d::Identity();
            system.add_pair(0, k, held, angle, 1.0, nail, 1.0);
            system.add_prior(k, held, 1.0, 0.0, {angle, 1e-3, 1e-3, 1e-3});
        }
        for (const auto global : {JointSystem::kRobotScale, JointSystem::kRobotOffset}) {
            system.add_global_prior(global, 0.0, 1.0);
        }
        system.add_global_prior(JointSystem::kScanScale, 0.0, 1e-12);
        ASSERT_TRUE(system.solve());
        for (int i = 0; i < 6; ++i) {
            const double expected = static_cast<std::size_t>(i) == g ? kStep : 0.0;
            EXPECT_NEAR(system.global_corrections()(i), expected, 0.02 * kStep)
                << "global " << i << " for truth " << g;
        }
    }
}

}  // namespace
}  // namespace gripscan
