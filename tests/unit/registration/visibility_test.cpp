// What a camera saw and what it looked through.
#include "core/registration/visibility.h"

#include <gtest/gtest.h>

#include "tests/support/random_pose.h"
#include "tests/support/synthetic_views.h"

namespace gripscan {
namespace {

using namespace test;

/// A plate across the view at 0.6 m, with a window in its middle.
Surface plate_with_window(const Pose& moved) {
    SolidPart part;
    using enum Primitive::Kind;
    part.primitives = {{kBox, {0.0, -0.03, 0.0}, {0.05, 0.012, 0.002}},
                       {kBox, {0.0, 0.03, 0.0}, {0.05, 0.012, 0.002}},
                       {kBox, {-0.034, 0.0, 0.0}, {0.016, 0.02, 0.002}},
                       {kBox, {0.034, 0.0, 0.0}, {0.016, 0.02, 0.002}}};
    Pose T = Pose::Identity();
    T.translation().z() = 0.6;
    ViewSettings settings;
    settings.noise_m = 0.1e-3;
    auto surface = make_surface(transformed(view_of(part, T, settings, 1), moved));
    EXPECT_TRUE(surface);
    return std::move(*surface);
}

TEST(DepthMap, TellsSeenHiddenAndLookedThrough) {
    SeededRandom random(4);
    for (int i = 0; i < 4; ++i) {
        // The map belongs to the viewpoint, wherever that is and looks.
        const Pose M = i == 0 ? Pose::Identity() : random_pose(random, 3.0);
        const DepthMap map(plate_with_window(M));
        const auto look = [&](double x, double y, double z) {
            return map.look((M * Eigen::Vector3d(x, y, z)).cast<float>(), 2e-3F);
        };
        EXPECT_EQ(look(0.035, 0.0, 0.598), Sight::kSeen);
        EXPECT_EQ(look(0.035, 0.0, 0.5995), Sight::kSeen);
        EXPECT_EQ(look(0.035, 0.0, 0.64), Sight::kHidden);
        EXPECT_EQ(look(0.033, 0.0, 0.57), Sight::kInFront);
        EXPECT_EQ(look(0.0, 0.0, 0.598), Sight::kNothing) << "through the window: no data";
        EXPECT_EQ(look(0.2, 0.0, 0.598), Sight::kNothing) << "beside all it saw";
        EXPECT_EQ(look(0.0, 0.0, -0.1), Sight::kNothing) << "behind the camera";
    }
}

TEST(DepthMap, EverySeenPointIsSeen) {
    const auto surface =
        make_surface(view_of(asymmetric_part(3), part_turned(cell_axis(), 0.5), {}, 3));
    ASSERT_TRUE(surface);
    const DepthMap map(*surface);
    for (const auto& p : surface->points) EXPECT_EQ(map.look(p, 1e-5F), Sight::kSeen);
}

TEST(Agreement, IsBestAtTheTruthAndSeesContradictions) {
    const ViewPair pair = pair_of_views(asymmetric_part(5), cell_axis(), 0.0, 0.3, 5);
    const auto source = make_surface(pair.source);
    const auto target = make_surface(pair.target);
    ASSERT_TRUE(source && target);
    const DepthMap source_map(*source);
    const DepthMap target_map(*target);
    const auto from = spread_sample(*source, 700);
    const auto to = spread_sample(*target, 700);
    const auto at = [&](const Pose& T, bool maps) {
        return agreement(*source, *target, maps ? &source_map : nullptr,
                         maps ? &target_map : nullptr, from, to, T, 1.5e-3);
    };
    const Agreement truth = at(pair.T_target_source, true);
    EXPECT_GT(truth.matched, 0.6);  // the rest is hidden from the other view
    EXPECT_LT(truth.contradicted, 0.05);
    EXPECT_DOUBLE_EQ(truth.score, truth.matched - truth.contradicted);
    EXPECT_EQ(at(pair.T_target_source, false).matched, truth.matched);
    EXPECT_EQ(at(pair.T_target_source, false).contradicted, 0.0);
    SeededRandom random(9);
    for (int i = 0; i < 6; ++i) {
        Vector6d off;
        off << 0.25 * random_direction(random), 0.01 * random_direction(random);
        const Pose T = motion_about(off, source->centre_m) * pair.T_target_source;
        EXPECT_LT(at(T, true).score, truth.score - 0.2);
    }
    const Agreement whole = agreement_at(*source, *target, pair.T_target_source, 700);
    EXPECT_NEAR(whole.matched, truth.matched, 0.1) << "another tolerance";
    EXPECT_LT(whole.contradicted, 0.05);
    // Nearer to the camera by 15 mm: most of it floats where a camera looked through.
    Pose nearer = Pose::Identity();
    nearer.translation().z() = -0.015;
    EXPECT_GT(at(nearer * pair.T_target_source, true).contradicted, 0.3);
}

}  // namespace
}  // namespace gripscan
