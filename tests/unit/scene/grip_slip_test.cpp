// An object that slips in the gripper is told from one that stays, by the two clouds alone.
#include "core/registration/grip_slip.h"

#include <gtest/gtest.h>

#include "core/registration/align_surfaces.h"
#include "core/scene/split_view.h"
#include "tests/unit/scene/held_scene.h"

namespace gripscan {
namespace {

using namespace test;

PreparedView prepared(const HeldScene& scene, const GripperTemplate& gripper, double turn_rad,
                      std::uint64_t seed, const Pose& slip) {
    CaptureFacts facts;
    facts.joint6_rad = turn_rad;
    return prepare_split_view(gripper, {}, facts, scene.view(turn_rad, seed, slip)).view;
}

/// A step of 10° during which the object moves in the gripper.
std::optional<GripSlip> slip_of_step(std::uint64_t seed, double from_deg, const Pose& slip) {
    const HeldScene scene(seed);
    const GripperTemplate gripper = scene.registered(seed);
    const PreparedView from =
        prepared(scene, gripper, rad_from_deg(from_deg), 10 * seed, Pose::Identity());
    const PreparedView to =
        prepared(scene, gripper, rad_from_deg(from_deg + 10.0), 10 * seed + 5, slip);
    EXPECT_TRUE(from.usable() && to.usable()) << from.flaw << to.flaw;
    if (!from.usable() || !to.usable()) return std::nullopt;
    const auto part = align_surfaces(from.surface, to.surface, {}, {}, for_each_in_order);
    return measure_grip_slip(from, to, *part, {});
}

Pose shifted(double along_x_m, double along_z_m) {
    return Pose(Eigen::Translation3d(along_x_m, 0.0, along_z_m));
}

class GripSlips : public testing::TestWithParam<std::uint64_t> {};

TEST_P(GripSlips, AnObjectThatStaysDoesNot) {
    for (const double from_deg : {10.0, 130.0, 250.0}) {
        const auto slip = slip_of_step(GetParam(), from_deg, Pose::Identity());
        ASSERT_TRUE(slip);
        EXPECT_FALSE(slipped(*slip, {})) << slip->shift_m << " m, " << slip->angle_rad << " rad";
    }
}

TEST_P(GripSlips, AMillimetreIsFound) {
    for (const Pose& moved : {shifted(1e-3, 0.0), shifted(0.0, 1e-3)}) {
        const auto slip = slip_of_step(GetParam(), 40.0, moved);
        ASSERT_TRUE(slip);
        EXPECT_TRUE(slipped(*slip, {})) << slip->shift_m;
        // The noise of both clouds leaves a tenth.
        EXPECT_NEAR(slip->shift_m, 1e-3, 0.3e-3);
    }
}

TEST_P(GripSlips, ADegreeIsFound) {
    Pose turned = Pose::Identity();
    turned.linear() = rotation_from_vector({0.0, rad_from_deg(1.0), 0.0});
    const Eigen::Vector3d at(0.052, 0.0, 0.0);
    turned.translation() = at - turned.linear() * at;
    const auto slip = slip_of_step(GetParam(), 160.0, turned);
    ASSERT_TRUE(slip);
    EXPECT_TRUE(slipped(*slip, {})) << slip->angle_rad;
    EXPECT_NEAR(deg_from_rad(slip->angle_rad), 1.0, 0.4);
}

INSTANTIATE_TEST_SUITE_P(Seeds, GripSlips, testing::Values(1U, 2U, 3U));

}  // namespace
}  // namespace gripscan
