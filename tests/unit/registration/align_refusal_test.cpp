// What cannot be aligned must be said, never returned as an alignment.
#include <gtest/gtest.h>

#include "core/registration/quality.h"
#include "tests/support/random_pose.h"
#include "tests/unit/registration/align_case.h"

namespace gripscan {
namespace {

using namespace test;

TEST(AlignRefuses, TooFewPoints) {
    const ViewPair pair = pair_of_views(asymmetric_part(1), cell_axis(), 0.0, 0.2, 1);
    std::vector<std::size_t> few(99);
    for (std::size_t i = 0; i < few.size(); ++i) few[i] = i;
    const Cloud scrap = select(pair.source, few);
    for (const auto& [source, target, side] :
         {std::tuple{scrap, pair.target, "source"}, std::tuple{pair.source, scrap, "target"},
          std::tuple{Cloud{}, pair.target, "source"}}) {
        const auto result = align(source, target, {}, {}, for_each_in_order);
        ASSERT_FALSE(result);
        EXPECT_THAT(result.error().message, testing::HasSubstr(side));
        EXPECT_THAT(result.error().message, testing::HasSubstr("at least 100"));
    }
}

TEST(AlignRefuses, TwoDifferentParts) {
    for (const std::uint64_t seed : {1, 2, 3}) {
        const Cloud a = view_of(asymmetric_part(seed), part_turned(cell_axis(), 0.0), {}, seed);
        SolidPart other;
        other.primitives = {{Primitive::Kind::kCylinder, {0, 0.01, 0}, {0.05, 0.012, 0.012}},
                            {Primitive::Kind::kBox, {0.03, -0.02, 0.01}, {0.008, 0.03, 0.006}}};
        const Cloud b = view_of(other, part_turned(cell_axis(), 0.4), {}, seed + 50);
        const Alignment result = aligned(a, b);
        EXPECT_NE(result.verdict, Verdict::kAccept) << result.sentence;
        EXPECT_NE(result.cause, Cause::kNone);
    }
}

/// A plate whose two sides have nothing in common: seen from the front and from the back it shares
/// no point, and no other pose makes them fit.
TEST(AlignRefuses, OppositeSidesOfAPart) {
    using enum Primitive::Kind;
    SolidPart part;
    part.primitives = {{kBox, {0.0, 0.0, 0.0}, {0.045, 0.035, 0.004}},
                       {kCylinder, {0.020, 0.012, 0.020}, {0.018, 0.012, 0.012}},
                       {kBox, {-0.022, -0.015, 0.015}, {0.010, 0.014, 0.014}},
                       {kBox, {-0.015, 0.020, -0.012}, {0.026, 0.006, 0.010}},
                       {kBox, {0.030, -0.018, -0.018}, {0.007, 0.010, 0.016}},
                       {kCylinder, {0.0, -0.020, -0.008}, {0.020, 0.005, 0.005}}};
    for (const std::uint64_t seed : {1, 2, 3, 4}) {
        const double from_rad = 0.2 * static_cast<double>(seed);
        const ViewPair pair =
            pair_of_views(part, cell_axis(), from_rad, from_rad + std::numbers::pi, seed);
        const Alignment a = aligned(pair.source, pair.target);
        EXPECT_NE(a.verdict, Verdict::kAccept) << a.sentence;
        EXPECT_NE(a.cause, Cause::kNone);
    }
}

class OnTheLathe : public testing::TestWithParam<double> {};

TEST_P(OnTheLathe, PartOfRevolutionIsNotAccepted) {
    const double contrast = GetParam();
    for (const std::uint64_t seed : {1, 2, 3}) {
        for (const double deg : {10.0, 20.0}) {
            const ViewPair pair = pair_of_views(part_of_revolution(seed, contrast), cell_axis(),
                                                0.0, rad_from_deg(deg), seed);
            const Alignment a = aligned(pair.source, pair.target);
            EXPECT_NE(a.verdict, Verdict::kAccept) << a.sentence;
            EXPECT_EQ(word(a.cause), "symmetry") << a.sentence;
            EXPECT_LT(a.observability, kLeastObservability);
        }
    }
}

INSTANTIATE_TEST_SUITE_P(PlainAndTextured, OnTheLathe, testing::Values(0.0, 25.0));

TEST(AlignRefuses, Noise) {
    SeededRandom random(3);
    Cloud a;
    Cloud b;
    for (Cloud* cloud : {&a, &b}) {
        for (int i = 0; i < 3000; ++i) {
            const Eigen::Vector3d p(random.uniform(-0.05, 0.05), random.uniform(-0.05, 0.05),
                                    random.uniform(0.55, 0.65));
            cloud->points.push_back(p.cast<float>());
        }
        cloud->viewpoint = Eigen::Vector3f::Zero();
    }
    EXPECT_NE(aligned(a, b).verdict, Verdict::kAccept);
}

}  // namespace
}  // namespace gripscan
