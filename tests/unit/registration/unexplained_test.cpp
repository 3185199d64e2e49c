// What does not belong to the part is found with its place and size; a healthy step leaves little.
#include "core/registration/unexplained.h"

#include <gtest/gtest.h>

#include "core/base/units.h"
#include "core/registration/diagnosis.h"
#include "tests/support/synthetic_views.h"

namespace gripscan {
namespace {

using namespace test;

const Box kRegion{{-0.2, -0.2, 0.45}, {0.2, 0.2, 0.75}};
/// Wide enough for what stands beside the part.
const ViewSettings kWide{.width_px = 150, .height_px = 180};
const SeenWhere kEverywhere{kRegion, ViewField{{-0.15, -0.18}, {0.15, 0.18}, 0.0}};

/// The part with a box of 40 mm that stands in front of it and does not turn.
Cloud view_with_box(const SolidPart& part, double angle_rad, const Eigen::Vector3d& centre_m,
                    std::uint64_t seed) {
    const Pose T = part_turned(cell_axis(), angle_rad);
    SolidPart both = part;
    // The box is one of the part's primitives for this view alone, put where it stands in space.
    const Eigen::Vector3d at = T.inverse() * centre_m;
    both.primitives.push_back({Primitive::Kind::kBox, at, {0.02, 0.02, 0.02}});
    return view_of(both, T, kWide, seed);
}

Surface surface_of(const Cloud& cloud) {
    auto surface = make_surface(cloud);
    EXPECT_TRUE(surface);
    return std::move(*surface);
}

double limit_m2(const Surface& a, const Surface& b) {
    return kMostUnexplained * std::pow(std::max(a.radius_m, b.radius_m), 2);
}

double largest_m2(const std::optional<Unexplained>& piece) {
    return piece ? piece->area_m2 : 0.0;
}

TEST(Unexplained, HealthyStepsStayFarBelowTheLimit) {
    for (const std::uint64_t seed : {1U, 2U, 3U}) {
        const SolidPart part = asymmetric_part(seed);
        for (const double step_deg : {10.0, 20.0}) {
            for (const double from_deg : {0.0, 70.0, 150.0, 260.0}) {
                const ViewPair pair =
                    pair_of_views(part, cell_axis(), rad_from_deg(from_deg),
                                  rad_from_deg(from_deg + step_deg), seed + 10, kWide);
                const Surface a = surface_of(pair.source);
                const Surface b = surface_of(pair.target);
                const double limit = limit_m2(a, b);
                EXPECT_LT(largest_m2(unexplained_part(a, b, pair.T_target_source, kEverywhere)),
                          0.5 * limit)
                    << seed << " " << from_deg;
                EXPECT_LT(
                    largest_m2(unexplained_part(b, a, pair.T_target_source.inverse(), kEverywhere)),
                    0.5 * limit)
                    << seed << " " << from_deg;
            }
        }
    }
}

TEST(Unexplained, AnIntruderIsFoundWhereItStands) {
    const Eigen::Vector3d centre_m(0.02, -0.065, 0.565);
    for (const std::uint64_t seed : {1U, 2U, 3U}) {
        const SolidPart part = asymmetric_part(seed);
        const Surface clean = surface_of(view_of(part, part_turned(cell_axis(), 0.0), kWide, seed));
        const Surface with =
            surface_of(view_with_box(part, rad_from_deg(20.0), centre_m, seed + 100));
        const Pose T = turn_about(cell_axis(), rad_from_deg(20.0));
        const auto piece = unexplained_part(with, clean, T.inverse(), kEverywhere);
        ASSERT_TRUE(piece);
        EXPECT_GT(piece->area_m2, 2.0 * limit_m2(clean, with));
        // Its front is seen: 40 mm x 40 mm at 20 mm before its centre.
        EXPECT_NEAR(piece->area_m2, 1600e-6, 600e-6);
        EXPECT_LT((piece->centre_m - (centre_m - Eigen::Vector3d(0, 0, 0.02))).norm(), 0.012);
        EXPECT_NEAR(piece->size_m, 0.045, 0.015);
        EXPECT_LT(piece->standing, 0.2) << "it was not there before";
        EXPECT_LT(piece->other_area_m2, 0.5 * piece->area_m2);
    }
}

TEST(Unexplained, WhatStandsInBothViewsIsToldToStand) {
    const Eigen::Vector3d centre_m(0.02, -0.065, 0.565);
    const SolidPart part = asymmetric_part(2);
    const Surface first = surface_of(view_with_box(part, 0.0, centre_m, 1));
    const Surface second = surface_of(view_with_box(part, rad_from_deg(20.0), centre_m, 2));
    const Pose T = turn_about(cell_axis(), rad_from_deg(20.0));
    // Turned away from the camera it hides behind itself; turned the other way it floats where the
    // first view looked through.
    const auto back = unexplained_part(second, first, T.inverse(), kEverywhere);
    const auto forth = unexplained_part(first, second, T, kEverywhere);
    const auto& piece = largest_m2(back) > largest_m2(forth) ? back : forth;
    ASSERT_TRUE(piece);
    EXPECT_GT(piece->area_m2, limit_m2(first, second));
    EXPECT_GT(piece->standing, 0.7);
}

/// A direction without data says nothing if nobody knows what the camera could have seen.
TEST(Unexplained, WithoutRegionAndFieldOnlyWhatWasLookedThroughCounts) {
    const Eigen::Vector3d beside_m(0.02, -0.065, 0.565);
    const SolidPart part = asymmetric_part(1);
    const Surface clean = surface_of(view_of(part, part_turned(cell_axis(), 0.0), kWide, 1));
    const Surface with = surface_of(view_with_box(part, rad_from_deg(20.0), beside_m, 2));
    const Pose T = turn_about(cell_axis(), rad_from_deg(20.0));
    const double known = largest_m2(unexplained_part(with, clean, T.inverse(), kEverywhere));
    EXPECT_LT(largest_m2(unexplained_part(with, clean, T.inverse(), {})), 0.5 * known);
}

TEST(Unexplained, OutsideTheFieldOfTheOtherViewNothingIsAsked) {
    const Eigen::Vector3d centre_m(0.02, -0.065, 0.565);
    const SolidPart part = asymmetric_part(1);
    const Surface clean = surface_of(view_of(part, part_turned(cell_axis(), 0.0), kWide, 1));
    const Surface with = surface_of(view_with_box(part, rad_from_deg(20.0), centre_m, 2));
    const Pose T = turn_about(cell_axis(), rad_from_deg(20.0));
    SeenWhere narrow = kEverywhere;
    narrow.field->min.y() = -0.05;  // 30 mm above the axis at its distance
    EXPECT_LT(largest_m2(unexplained_part(with, clean, T.inverse(), narrow)),
              limit_m2(clean, with));
}

}  // namespace
}  // namespace gripscan
