// Known turns of synthetic parts, found from the identity and nothing else.
#include "core/registration/align.h"

#include <gtest/gtest.h>

#include "core/concurrency/worker_pool.h"
#include "tests/support/random_pose.h"
#include "tests/unit/registration/align_case.h"

namespace gripscan {
namespace {

using namespace test;

/// The estimate takes all six unknowns from the data, so the turn is known less well than the rule
/// of thumb (which holds the other five fixed); four times covers that and 3 sigma in all of the
/// runs below. Grid sampling adds a share of the pixel (1.2 mm), 1/20 of it at an arm of 25 mm.
double tolerance_deg(const ViewPair& pair, const Axis& axis, const ViewSettings& settings) {
    return 4.0 * deg_from_rad(rule_of_thumb_rad(pair.source, axis.direction, settings)) + 0.14;
}

/// Without texture only the few faces across the axis hold the shift along it: 100 points of 0.2 mm
/// noise, 4 π of them worth one, seen at a grazing angle. Such a shift may slide by some tenths.
constexpr double kShapeAlone_mm = 1.0;

struct Turn {
    std::uint64_t seed;
    double deg;
    bool any_axis = false;
};

void PrintTo(const Turn& turn, std::ostream* out) {
    *out << "seed " << turn.seed << ", " << turn.deg << " deg";
}

class KnownTurn : public testing::TestWithParam<Turn> {};

TEST_P(KnownTurn, IsFoundFromTheIdentity) {
    const Turn turn = GetParam();
    Axis axis = cell_axis();
    if (turn.any_axis) {
        SeededRandom random(turn.seed);
        axis.direction = random_direction(random);
    }
    const ViewSettings view;
    const SolidPart part = asymmetric_part(turn.seed);
    const ViewPair pair = pair_of_views(part, axis, 0.3, 0.3 + rad_from_deg(turn.deg), turn.seed);
    const Alignment a = aligned(pair.source, pair.target);
    ASSERT_TRUE(a.found) << a.sentence;
    EXPECT_EQ(word(a.verdict), "accept") << a.sentence;
    const double limit_deg = tolerance_deg(pair, axis, view);
    EXPECT_THAT(a.T_target_source,
                IsPose(pair.T_target_source, centroid(pair.source), limit_deg, 0.3));
    const double error_rad = a.angle_rad - std::abs(rad_from_deg(turn.deg));
    EXPECT_LT(std::abs(error_rad), 4.0 * a.sigma_angle_rad)
        << deg_from_rad(error_rad) << " deg, sigma " << deg_from_rad(a.sigma_angle_rad);
    EXPECT_LT(deg_from_rad(a.sigma_angle_rad), 0.35);
    EXPECT_TRUE(a.starts_agree);
    EXPECT_GT(std::copysign(1.0, turn.deg) * a.axis.dot(axis.direction),
              std::cos(rad_from_deg(6.0 * limit_deg)));
    EXPECT_GT(a.observability, 0.15);
    // Both surfaces' noise along the normal, facing or tilted.
    EXPECT_LT(kMmPerM * a.rms_m, 1.6 * std::sqrt(2.0) * kMmPerM * view.noise_m);
}

INSTANTIATE_TEST_SUITE_P(Turns, KnownTurn,
                         testing::Values(Turn{1, 5}, Turn{2, 10}, Turn{3, 10}, Turn{4, 15},
                                         Turn{5, 20}, Turn{6, 30}, Turn{7, 40}, Turn{8, -10},
                                         Turn{19, -25}, Turn{10, 10, true}, Turn{11, 20, true},
                                         Turn{12, 30, true}));

class ThePair : public testing::Test {
  protected:
    const Axis axis_ = cell_axis();
    const ViewPair pair_ = pair_of_views(asymmetric_part(21), axis_, 1.0, 1.2, 21);
    const Alignment a_ = aligned(pair_.source, pair_.target);
    const Eigen::Vector3d middle_ = centroid(pair_.source);
};

TEST_F(ThePair, ExchangedGivesTheInverse) {
    const Alignment back = aligned(pair_.target, pair_.source);
    // The same data and the same noise: only samples and rounding differ.
    EXPECT_THAT(back.T_target_source.inverse(),
                IsPose(a_.T_target_source, middle_, deg_from_rad(a_.sigma_angle_rad), 0.1));
    EXPECT_EQ(back.verdict, a_.verdict);
    EXPECT_NEAR(back.overlap, a_.overlap, 0.03);
}

TEST_F(ThePair, BothMovedGiveTheMovedTurn) {
    SeededRandom random(5);
    for (int i = 0; i < 2; ++i) {
        const Pose M = random_pose(random, 3.0);
        const Alignment moved = aligned(transformed(pair_.source, M), transformed(pair_.target, M));
        const Pose expected = M * a_.T_target_source * M.inverse();
        // A grid that no pinhole along z explains has no texture; shape alone is left.
        const double limit_deg = tolerance_deg(pair_, axis_, {});
        EXPECT_THAT(moved.T_target_source,
                    IsPose(expected, M * middle_, limit_deg, kShapeAlone_mm));
        EXPECT_LT(std::abs(moved.angle_rad - a_.angle_rad),
                  3.0 * std::hypot(moved.sigma_angle_rad, a_.sigma_angle_rad));
    }
}

TEST_F(ThePair, SourceMovedBeforehandGivesTheTurnFromThere) {
    SeededRandom random(6);
    for (int i = 0; i < 2; ++i) {
        const Pose M = motion_about(
            (Vector6d() << 0.35 * random_direction(random), 0.02 * random_direction(random))
                .finished(),
            middle_);
        const Alignment moved = aligned(transformed(pair_.source, M), pair_.target);
        EXPECT_THAT(moved.T_target_source * M,
                    IsPose(pair_.T_target_source, middle_, tolerance_deg(pair_, axis_, {}),
                           kShapeAlone_mm));
    }
}

TEST_F(ThePair, NumberOfThreadsDoesNotMatter) {
    WorkerPool pool(3);
    const auto threaded = align(pair_.source, pair_.target, {}, {}, pool.for_each());
    ASSERT_TRUE(threaded);
    EXPECT_TRUE(threaded->T_target_source.matrix() == a_.T_target_source.matrix());
    EXPECT_TRUE(threaded->covariance == a_.covariance);
    EXPECT_EQ(threaded->sigma_angle_rad, a_.sigma_angle_rad);
    EXPECT_EQ(threaded->observability, a_.observability);
    EXPECT_EQ(threaded->overlap, a_.overlap);
    EXPECT_EQ(threaded->sentence, a_.sentence);
}

TEST_F(ThePair, SeedOfTheStartsDoesNotMatter) {
    AlignSettings settings;
    settings.seed = 77;
    const Alignment other = aligned(pair_.source, pair_.target, settings);
    EXPECT_THAT(other.T_target_source,
                IsPose(a_.T_target_source, middle_, deg_from_rad(a_.sigma_angle_rad), 0.1));
}

TEST_F(ThePair, WorksWithoutWhatACloudMayLack) {
    ViewPair bare = pair_;
    for (Cloud* cloud : {&bare.source, &bare.target}) {
        cloud->normals.clear();
        cloud->intensity.clear();
        cloud->sigma.clear();
        cloud->cell.clear();
        cloud->grid_width = cloud->grid_height = 0;
        cloud->viewpoint.reset();
    }
    const Alignment a = aligned(bare.source, bare.target);
    EXPECT_EQ(word(a.verdict), "accept") << a.sentence;
    EXPECT_THAT(a.T_target_source, IsPose(pair_.T_target_source, middle_,
                                          tolerance_deg(pair_, axis_, {}), kShapeAlone_mm));
}

TEST_F(ThePair, IsCancelled) {
    std::stop_source stop;
    stop.request_stop();
    const auto result =
        align(pair_.source, pair_.target, {}, {stop.get_token(), {}}, for_each_in_order);
    ASSERT_FALSE(result);
    EXPECT_EQ(result.error().kind, ErrorKind::kCancelled);
}

}  // namespace
}  // namespace gripscan
