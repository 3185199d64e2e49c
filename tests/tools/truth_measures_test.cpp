#include <gtest/gtest.h>

#include "core/base/seeded_random.h"
#include "core/base/units.h"
#include "core/sim/mesh.h"
#include "core/sim/surface_samples.h"
#include "tests/tools/pose_score.h"
#include "tests/tools/template_score.h"

namespace gripscan::test {
namespace {

Surface surface_of(const sim::Mesh& mesh) {
    return {mesh.vertices, mesh.triangles};
}

Cloud cloud_of(const std::vector<sim::SurfaceSample>& samples, double lift_m = 0.0) {
    Cloud cloud;
    for (const auto& sample : samples) {
        cloud.points.push_back((sample.point_m + lift_m * sample.normal).cast<float>());
    }
    return cloud;
}

TEST(SurfaceDistance, EqualsTheDistanceToABoxEverywhere) {
    const Eigen::Vector3d half(0.05, 0.03, 0.02);
    // Cutting the edges by c takes at most 2c/√3 away, at the corners.
    const SurfaceDistance distance(surface_of(sim::chamfered_box(2.0 * half, 1e-5)));
    SeededRandom random(5);
    for (int i = 0; i < 2000; ++i) {
        const Eigen::Vector3d p(random.uniform(-0.1, 0.1), random.uniform(-0.1, 0.1),
                                random.uniform(-0.1, 0.1));
        const Eigen::Vector3d q = p.cwiseAbs() - half;
        const double outside = q.cwiseMax(0.0).norm();
        const double expected = outside > 0.0 ? outside : -q.maxCoeff();
        EXPECT_NEAR(distance.distance_m(p), expected, 1.16e-5);
    }
}

TEST(TemplateScore, TellsDistanceAndCoverage) {
    const sim::Mesh box = sim::chamfered_box({0.1, 0.08, 0.06}, 0.001);
    Truth truth;
    truth.surface = surface_of(box);
    truth.visible = cloud_of(sim::sample_surface(box, 0.001));

    const TemplateScore perfect = score_template(truth.visible, Pose::Identity(), truth);
    EXPECT_LT(perfect.rms_mm, 1e-4);
    EXPECT_EQ(perfect.coverage, 1.0);

    // Points 0.5 mm off every face: exactly that, with nothing left out.
    const Cloud off = cloud_of(sim::sample_surface(box, 0.001), 0.0005);
    const TemplateScore lifted = score_template(off, Pose::Identity(), truth);
    EXPECT_NEAR(lifted.rms_mm, 0.5, 0.005);
    EXPECT_NEAR(lifted.p50_mm, 0.5, 0.005);

    // The half of it with x > 0 covers half of what was visible.
    const Cloud half = crop(truth.visible, {{0, -1, -1}, {1, 1, 1}});
    EXPECT_NEAR(score_template(half, Pose::Identity(), truth).coverage, 0.5, 0.02);

    // One stray point in a thousand is in the root mean square and in the maximum.
    Cloud stray = truth.visible;
    const std::size_t strays = stray.size() / 1000;
    for (std::size_t i = 0; i < strays; ++i) stray.points.emplace_back(0.0F, 0.0F, 0.06F);
    const TemplateScore with_strays = score_template(stray, Pose::Identity(), truth);
    EXPECT_NEAR(with_strays.max_mm, 30.0, 1e-3);
    EXPECT_NEAR(with_strays.rms_mm, 30.0 * std::sqrt(0.001), 0.05);
}

TEST(TemplateScore, BringsTheTemplateIntoTheTruthsFrame) {
    const sim::Mesh box = sim::chamfered_box({0.1, 0.08, 0.06}, 0.001);
    Truth truth;
    truth.surface = surface_of(box);
    truth.visible = cloud_of(sim::sample_surface(box, 0.001));
    const Pose T = turn_about({{0.1, 0.2, 0.3}, Eigen::Vector3d::UnitX()}, 0.4);
    const Cloud elsewhere = transformed(truth.visible, T.inverse());
    EXPECT_LT(score_template(elsewhere, T, truth).rms_mm, 1e-3);
}

TEST(PoseErrors, AreRelativeToTheFirstCaptureWithAPose) {
    Truth truth;
    truth.axis = {{0, 0.01, 0.74}, Eigen::Vector3d(1, 0.02, -0.01).normalized()};
    const auto true_pose = [&](int k) { return turn_about(truth.axis, -rad_from_deg(10.0 * k)); };
    for (int k = 0; k < 4; ++k) truth.captures[k] = {true_pose(k), 10.0 * k - 180.0};

    Turns turns;  // capture 0 was not used; capture 3 is off by 0.1° about the axis and 0.2 mm
    turns.T_first_k[1] = Pose::Identity();
    turns.T_first_k[2] = true_pose(1).inverse() * true_pose(2);
    Pose off = turn_about(truth.axis, rad_from_deg(0.1));
    off.translation() += Eigen::Vector3d(0, 0.0002, 0);
    turns.T_first_k[3] = off * true_pose(1).inverse() * true_pose(3);
    turns.steps = {{1, 2, 10.05}, {2, 3, std::nullopt}};

    const auto errors = pose_errors(turns, truth, {0.05, 0.0, 0.75});
    ASSERT_EQ(errors.size(), 3U);
    EXPECT_NEAR(errors[1].rotation_deg, 0.0, 1e-9);
    EXPECT_NEAR(errors[1].shift_mm, 0.0, 1e-9);
    EXPECT_NEAR(errors[2].rotation_deg, 0.1, 1e-9);
    EXPECT_NEAR(errors[2].shift_mm, 0.2, 1e-9);

    const auto steps = step_errors(turns, truth);
    ASSERT_EQ(steps.size(), 2U);
    EXPECT_NEAR(steps[0].error_deg.value(), 0.05, 1e-9);
    EXPECT_FALSE(steps[1].error_deg.has_value());
}

}  // namespace
}  // namespace gripscan::test
