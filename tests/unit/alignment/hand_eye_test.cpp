// The robot-camera alignment on poses whose answer is known.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/alignment/hand_eye.h"
#include "core/alignment/robot_alignment.h"
#include "core/base/seeded_random.h"
#include "core/base/units.h"
#include "tests/support/random_pose.h"

namespace gripscan {
namespace {

struct Truth {
    HandEyePoses poses;
    std::vector<HandEyeView> views;
};

Pose noise_pose(SeededRandom& random, double sd_rad, double sd_m) {
    Pose T = Pose::Identity();
    T.linear() = rotation_from_vector(
        sd_rad * Eigen::Vector3d(random.normal(), random.normal(), random.normal()));
    T.translation() = sd_m * Eigen::Vector3d(random.normal(), random.normal(), random.normal());
    return T;
}

/// `turn_rad` about a random axis (or the flange's own) between the views.
Truth truth_of(Mounting mounting, int count, double turn_rad, std::uint64_t seed,
               bool one_axis = false) {
    SeededRandom random(seed);
    Truth truth;
    truth.poses.X = test::random_pose(random, 2.5);
    truth.poses.Y = test::random_pose(random, 2.5);
    const Pose base = test::random_pose(random, 1.0);
    for (int i = 0; i < count; ++i) {
        Pose T_robot_flange = base;
        const Eigen::Vector3d axis =
            one_axis ? Eigen::Vector3d::UnitZ() : test::random_direction(random);
        T_robot_flange.linear() =
            base.linear() * rotation_from_vector(random.uniform(-turn_rad, turn_rad) * axis);
        if (!one_axis) {
            T_robot_flange.translation() +=
                0.15 * Eigen::Vector3d(random.normal(), random.normal(), random.normal());
        }
        const HandEyeView view{T_robot_flange, {}};
        const Pose A = fixed_side(view, mounting);
        truth.views.push_back(
            {T_robot_flange, truth.poses.X.inverse() * A.inverse() * truth.poses.Y});
    }
    return truth;
}

void expect_near(const Pose& a, const Pose& b, double mm, double deg) {
    EXPECT_LT(kMmPerM * (a.translation() - b.translation()).norm(), mm);
    EXPECT_LT(deg_from_rad(rotation_angle_rad(a.linear().transpose() * b.linear())), deg);
}

TEST(HandEye, IsExactWithoutNoiseForBothMountingsAndAnyTurns) {
    for (const Mounting mounting : {Mounting::kBoardOnFlange, Mounting::kCameraOnFlange}) {
        for (const double turn_rad : {0.5, 2.5}) {
            for (std::uint64_t seed = 1; seed <= 5; ++seed) {
                const Truth truth = truth_of(mounting, 15, turn_rad, seed);
                const auto candidates = solve_hand_eye(truth.views, mounting);
                ASSERT_TRUE(candidates) << candidates.error().message;
                EXPECT_EQ(candidates->front().method, "Park");
                const HandEyeCandidate& best = best_of(*candidates);
                expect_near(best.poses.X, truth.poses.X, 1e-3, 1e-4);
                expect_near(best.poses.Y, truth.poses.Y, 1e-3, 1e-4);
                EXPECT_LT(best.spread.max_m, 1e-6);
            }
        }
    }
}

TEST(HandEye, StaysWithinTheNoiseOfRobotAndCamera) {
    // 0.1 mm and 0.03 deg of noise in the board's pose, which moves a board that stands up to 1.7 m
    // away by 0.9 mm in every direction. Over 15 views, with twice the noise for the parallel part
    // of the turns, that leaves 0.8 mm (rms); three times that is the limit.
    for (std::uint64_t seed = 1; seed <= 8; ++seed) {
        SeededRandom random(100 + seed);
        Truth truth = truth_of(Mounting::kBoardOnFlange, 15, 0.8, seed);
        for (HandEyeView& view : truth.views) {
            view.T_camera_board =
                view.T_camera_board * noise_pose(random, rad_from_deg(0.03), 0.0001);
        }
        const auto candidates = solve_hand_eye(truth.views, Mounting::kBoardOnFlange);
        ASSERT_TRUE(candidates);
        const HandEyeCandidate& best = best_of(*candidates);
        expect_near(best.poses.X, truth.poses.X, 2.5, 0.08);
        EXPECT_LT(best.spread.rms_m, 0.003);
    }
}

TEST(HandEye, WrongMethodsAreNotChosen) {
    // With turns beyond a right angle some closed forms are wrong by decimetres.
    int wrong = 0;
    for (std::uint64_t seed = 1; seed <= 5; ++seed) {
        const Truth truth = truth_of(Mounting::kBoardOnFlange, 15, 3.0, seed);
        const auto candidates = solve_hand_eye(truth.views, Mounting::kBoardOnFlange);
        ASSERT_TRUE(candidates);
        for (const HandEyeCandidate& candidate : *candidates) {
            if (candidate.spread.max_m > 0.005) ++wrong;
        }
        expect_near(best_of(*candidates).poses.X, truth.poses.X, 1e-3, 1e-4);
    }
    EXPECT_GT(wrong, 0) << "the choice has not been put to the test";
}

TEST(HandEye, RefusesWhatCannotTell) {
    const Truth joint6 = truth_of(Mounting::kBoardOnFlange, 12, 2.5, 1, true);
    const auto refused = solve_hand_eye(joint6.views, Mounting::kBoardOnFlange);
    ASSERT_FALSE(refused);
    EXPECT_THAT(refused.error().message, testing::HasSubstr("one axis"));
    const Truth small = truth_of(Mounting::kBoardOnFlange, 12, 0.05, 2);
    const auto still = solve_hand_eye(small.views, Mounting::kBoardOnFlange);
    ASSERT_FALSE(still);
    EXPECT_THAT(still.error().message, testing::HasSubstr("must be turned"));
    const Truth two = truth_of(Mounting::kBoardOnFlange, 2, 1.0, 3);
    EXPECT_FALSE(solve_hand_eye(two.views, Mounting::kBoardOnFlange));
}

/// Corners of a board as a stereo camera would find them, with noise.
std::vector<AlignmentView> observed(const Truth& truth, const RectifiedRig& camera, double noise_px,
                                    SeededRandom& random) {
    std::vector<AlignmentView> views;
    for (const HandEyeView& view : truth.views) {
        AlignmentView seen{view.T_robot_flange, {}};
        for (int i = 0; i < 54; ++i) {
            const Eigen::Vector3d b(0.02 * (i % 9), 0.02 * (i / 9), 0.0);
            const Eigen::Vector3d p = view.T_camera_board * b;
            const auto noise = [&] {
                return Eigen::Vector2d(noise_px * random.normal(), noise_px * random.normal());
            };
            seen.board.board_m.push_back(b);
            seen.board.left_px.push_back(left_pixel(camera, p) + noise());
            seen.board.right_px.push_back(right_pixel(camera, p) + noise());
        }
        seen.board.T_camera_board = view.T_camera_board;
        views.push_back(std::move(seen));
    }
    return views;
}

/// As truth_of(), with boards that the camera sees: 0.7 m away, tilted by up to 40 degrees.
Truth visible_truth(std::uint64_t seed, int count) {
    SeededRandom random(seed);
    Truth truth;
    truth.poses.X = test::random_pose(random, 2.5);
    truth.poses.Y = test::random_pose(random, 0.5);
    truth.poses.Y.translation() *= 0.1;
    for (int i = 0; i < count; ++i) {
        Pose T_camera_board = Pose::Identity();
        T_camera_board.linear() =
            rotation_from_vector(random.uniform(0.1, 0.7) * test::random_direction(random));
        T_camera_board.translation() = Eigen::Vector3d(
            random.uniform(-0.15, 0.0), random.uniform(-0.15, 0.0), random.uniform(0.6, 0.8));
        // T_robot_flange · Y = X · T_camera_board
        truth.views.push_back(
            {truth.poses.X * T_camera_board * truth.poses.Y.inverse(), T_camera_board});
    }
    return truth;
}

TEST(RobotAlignment, IsRefinedAndKnowsHowWell) {
    const RectifiedRig camera{{1280, 960}, 985.0, 640.0, 640.0, 480.0, 0.12};
    double squares = 0.0;
    constexpr int kRounds = 12;
    for (std::uint64_t seed = 1; seed <= kRounds; ++seed) {
        const Truth truth = visible_truth(seed, 12);
        SeededRandom random(200 + seed);
        auto views = observed(truth, camera, 0.1, random);
        for (AlignmentView& view : views) {  // the robot is good to 0.05 mm and 0.01 deg
            view.T_robot_flange =
                view.T_robot_flange * noise_pose(random, rad_from_deg(0.01), 0.00005);
        }
        const auto alignment =
            align_robot(views, camera, Mounting::kBoardOnFlange, AlignmentLimits{}, {});
        ASSERT_TRUE(alignment) << alignment.error().message;
        EXPECT_FALSE(alignment->rejected) << alignment->reason;
        const double error_m =
            (alignment->poses.X.translation() - truth.poses.X.translation()).norm();
        EXPECT_LT(error_m, 0.0010);
        EXPECT_LT(alignment->reprojection_px, 0.3);
        squares += error_m * error_m / (alignment->sd_m * alignment->sd_m);
    }
    // Errors in units of their predicted deviation: 1 on average; 12 rounds of 3 numbers scatter by
    // a quarter, and a jackknife over 12 views by as much.
    const double ratio = std::sqrt(squares / kRounds);
    EXPECT_GT(ratio, 0.5);
    EXPECT_LT(ratio, 1.8);
}

TEST(RobotAlignment, IsRejectedWhereViewsDisagree) {
    const RectifiedRig camera{{1280, 960}, 985.0, 640.0, 640.0, 480.0, 0.12};
    const Truth truth = visible_truth(5, 10);
    SeededRandom random(7);
    auto views = observed(truth, camera, 0.1, random);
    std::swap(views[2].T_robot_flange, views[6].T_robot_flange);  // images mixed up
    const auto alignment =
        align_robot(views, camera, Mounting::kBoardOnFlange, AlignmentLimits{}, {});
    ASSERT_TRUE(alignment);
    EXPECT_TRUE(alignment->rejected);
    EXPECT_THAT(alignment->reason, testing::HasSubstr("disagree"));
}

}  // namespace
}  // namespace gripscan
