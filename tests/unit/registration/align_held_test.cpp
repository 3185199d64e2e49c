// A round part in a gripper: its turn is shown by its texture, by the gripper, or not at all.
#include "core/registration/align_held.h"

#include <gtest/gtest.h>

#include "core/base/units.h"
#include "core/registration/quality.h"
#include "tests/support/synthetic_views.h"

namespace gripscan {
namespace {

using namespace test;

constexpr double kStep_deg = 10.0;

/// A view of both, apart from each other so that nothing is hidden.
struct Held {
    Surface part;
    Holder holder;

    Held(const SolidPart& solid, const SolidPart& gripper, double turn_deg, std::uint64_t seed) {
        const Pose T = part_turned(cell_axis(), rad_from_deg(turn_deg));
        part = make_surface(view_of(solid, T, {}, seed)).value();
        holder = make_holder(view_of(gripper, T, {}, seed + 1), T);
    }
    [[nodiscard]] HeldSurface surface() const { return {part, holder}; }
};

Alignment turned(double contrast, const SolidPart& gripper, std::uint64_t seed) {
    const SolidPart solid = part_of_revolution(seed, contrast);
    const Held from(solid, gripper, 20.0, 10 * seed);
    const Held to(solid, gripper, 20.0 + kStep_deg, 10 * seed + 5);
    return align_held(from.surface(), to.surface(), {}, {}, for_each_in_order).value();
}

class HeldRoundPart : public testing::TestWithParam<std::uint64_t> {
  protected:
    const SolidPart round_gripper = part_of_revolution(9, 0.0);
};

/// Texture of 25 levels under noise of one: a turn beside the answer looks plainly different.
TEST_P(HeldRoundPart, IsTurnedAsItsTextureShows) {
    const Alignment found = turned(25.0, round_gripper, GetParam());
    ASSERT_TRUE(found.found);
    EXPECT_GE(found.observability, kLeastObservability);
    EXPECT_EQ(found.verdict, Verdict::kAccept) << found.sentence;
    EXPECT_NEAR(deg_from_rad(found.angle_rad), kStep_deg, 0.3);
}

TEST_P(HeldRoundPart, WithoutTextureMovesWithItsGripper) {
    const Alignment found = turned(0.0, asymmetric_part(1), GetParam());
    EXPECT_EQ(found.verdict, Verdict::kAccept) << found.sentence;
    EXPECT_NEAR(deg_from_rad(found.angle_rad), kStep_deg, 0.3);
}

TEST_P(HeldRoundPart, WithoutTextureInARoundGripperShowsNoTurn) {
    const Alignment found = turned(0.0, round_gripper, GetParam());
    EXPECT_LT(found.observability, kLeastObservability);
    EXPECT_EQ(found.verdict, Verdict::kReject);
}

INSTANTIATE_TEST_SUITE_P(Seeds, HeldRoundPart, testing::Values(1U, 2U));

}  // namespace
}  // namespace gripscan
