// Texture as a witness of motion: where it looks, and how its rows answer to a motion.
#include "core/registration/texture_rows.h"

#include <gtest/gtest.h>

#include <Eigen/Cholesky>

#include "tests/support/random_pose.h"
#include "tests/support/synthetic_views.h"

namespace gripscan {
namespace {

using namespace test;

ViewSettings clean_view() {
    ViewSettings settings{.width_px = 200, .height_px = 160, .focal_px = 900.0};
    settings.noise_m = 0.0;
    settings.grey_noise = 0.0;
    return settings;
}

Surface surface_of(const Cloud& cloud) {
    auto surface = make_surface(cloud);
    EXPECT_TRUE(surface);
    return std::move(*surface);
}

TEST(TextureGrid, FindsEveryPointAtItsCell) {
    const Cloud cloud = view_of(asymmetric_part(2), part_turned(cell_axis(), 0.3), clean_view(), 1);
    const auto grid = TextureGrid::create(cloud);
    ASSERT_TRUE(grid);
    std::size_t seen = 0;
    for (std::size_t i = 0; i < cloud.size(); ++i) {
        const auto sample = grid->look(cloud.points[i]);
        if (!sample) continue;  // next to a rim
        ++seen;
        EXPECT_EQ(sample->point, static_cast<std::int32_t>(i));
        EXPECT_NEAR(sample->value, cloud.intensity[i], 0.2);
    }
    EXPECT_GT(seen, cloud.size() / 2);
    EXPECT_FALSE(grid->look(Eigen::Vector3f(0.0F, 0.0F, -0.6F))) << "behind the camera";
    EXPECT_FALSE(grid->look(Eigen::Vector3f(0.5F, 0.0F, 0.6F))) << "beside the part";
}

TEST(TextureGrid, GradientIsThatOfTheLookedUpValue) {
    const Cloud cloud = view_of(asymmetric_part(2), part_turned(cell_axis(), 0.3), clean_view(), 1);
    const auto grid = TextureGrid::create(cloud);
    ASSERT_TRUE(grid);
    SeededRandom random(3);
    int compared = 0;
    for (std::size_t i = 0; i < cloud.size(); i += 37) {
        const Eigen::Vector3f d = (1.5e-5 * random_direction(random)).cast<float>();
        const auto here = grid->look(cloud.points[i]);
        const auto there = grid->look(cloud.points[i] + d);
        const auto back = grid->look(cloud.points[i] - d);
        if (!here || !there || !back) continue;
        const float expected =
            2.0F * d.dot(grid->gradient_at(cloud.points[i], here->by_u, here->by_v));
        // Points lie on the knots of the cubic, where its curvature jumps: 0.02 px beside them that
        // is some hundredths of a level.
        EXPECT_NEAR(there->value - back->value, expected, 0.02F + 0.05F * std::abs(expected));
        ++compared;
    }
    EXPECT_GT(compared, 100);
}

TEST(TextureGrid, NothingWithoutAPinholeGrid) {
    const Cloud cloud = view_of(asymmetric_part(2), part_turned(cell_axis(), 0.3), clean_view(), 1);
    Cloud lacking = cloud;
    lacking.intensity.clear();
    EXPECT_FALSE(TextureGrid::create(lacking));
    lacking = cloud;
    lacking.viewpoint.reset();
    EXPECT_FALSE(TextureGrid::create(lacking));
    lacking = cloud;
    lacking.grid_width = lacking.grid_height = 0;
    EXPECT_FALSE(TextureGrid::create(lacking));
    SeededRandom random(3);
    EXPECT_FALSE(TextureGrid::create(transformed(cloud, random_pose(random, 3.0))));
}

double squares(const std::vector<ResidualRow>& rows) {
    double sum = 0.0;
    for (const ResidualRow& row : rows) sum += row.residual * row.residual;
    return sum / static_cast<double>(rows.size());
}

class TextureOfAPair : public testing::TestWithParam<int> {
  protected:
    const ViewPair pair_ =
        pair_of_views(asymmetric_part(6), cell_axis(), 0.2, 0.35, 6, clean_view());
    const Surface source_ = surface_of(pair_.source);
    const Surface target_ = surface_of(pair_.target);
    const Eigen::Vector3d centre_ = pair_.T_target_source * source_.centre_m;
    [[nodiscard]] std::vector<ResidualRow> rows_at(const Vector6d& off) const {
        return texture_rows(source_, target_, motion_about(off, centre_) * pair_.T_target_source,
                            GetParam(), 3e-3, centre_);
    }
};

TEST_P(TextureOfAPair, FitsBestAtTheTruth) {
    const auto truth = rows_at(Vector6d::Zero());
    ASSERT_GT(truth.size(), 500U);
    for (int k = 0; k < 6; ++k) {
        if (k == 5) continue;  // along the ray texture says little
        for (const double sign : {-1.0, 1.0}) {
            const Vector6d off = sign * (k < 3 ? 0.03 : 1e-3) * Vector6d::Unit(k);
            EXPECT_GT(squares(rows_at(off)), squares(truth)) << "unknown " << k;
        }
    }
}

/// The rows' sums, not single rows: the set of visible cells changes with the pose. Moving by u
/// must change Σ r² as the Jacobians say: its slope, by finite differences beside the truth.
TEST_P(TextureOfAPair, JacobiansPointTheRightWay) {
    SeededRandom random(11);
    for (int i = 0; i < 6; ++i) {
        Vector6d u;
        u << 0.006 * random_direction(random), 2e-4 * random_direction(random);
        const auto rows = rows_at(u);
        double predicted = 0.0;
        for (const ResidualRow& row : rows) predicted += 2.0 * row.residual * row.J.dot(u);
        predicted /= static_cast<double>(rows.size());
        constexpr double kStep = 0.2;
        const double slope =
            (squares(rows_at((1.0 + kStep) * u)) - squares(rows_at((1.0 - kStep) * u))) /
            (2.0 * kStep);
        EXPECT_GT(slope, 0.0);
        // Local mean and deviation move too and take a part of the change with them, which the rows
        // leave out: they ask for more than there is, but never for twice.
        EXPECT_GT(predicted / slope, 0.75);
        EXPECT_LT(predicted / slope, 1.75);
    }
}

/// Gauss–Newton on texture alone comes home from half a pixel and more.
TEST_P(TextureOfAPair, LeadsBackToTheTruth) {
    SeededRandom random(12);
    Vector6d off;
    off << 0.01 * random_direction(random), 3e-4 * random_direction(random);
    Pose T = motion_about(off, centre_);
    for (int step = 0; step < 10; ++step) {
        NormalEquations sums;
        add_rows(
            texture_rows(source_, target_, T * pair_.T_target_source, GetParam(), 3e-3, centre_),
            1.0, sums);
        T = motion_about(-sums.H.ldlt().solve(sums.g), centre_) * T;
    }
    // A tenth of a pixel (0.67 mm) at an arm of 30 mm is 0.13 degrees.
    EXPECT_LT(rotation_angle_rad(T.linear()), 0.004);
    EXPECT_LT((T * centre_ - centre_).head<2>().norm(), 1e-4);
}

TEST_P(TextureOfAPair, NoRowsWithoutBrightness) {
    Cloud plain = pair_.source;
    plain.intensity.clear();
    EXPECT_TRUE(
        texture_rows(surface_of(plain), target_, pair_.T_target_source, GetParam(), 3e-3, centre_)
            .empty());
}

INSTANTIATE_TEST_SUITE_P(Scales, TextureOfAPair, testing::Range(0, kTextureScales));

}  // namespace
}  // namespace gripscan
