// The cell check on the simulated cell: no false alarm on a healthy one, and every thing that is
// wrong fails its own item and no other.
#include <gmock/gmock.h>

#include "core/base/units.h"
#include "tests/unit/procedure/cell_bench.h"

namespace gripscan::test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

Eigen::Vector3d centre(const Box& box) {
    return 0.5 * (box.min_m + box.max_m);
}

class HealthyCell : public testing::TestWithParam<std::uint64_t> {};

TEST_P(HealthyCell, PassesBeforeAndAfterTheWarmUp) {
    CellBench bench(GetParam());
    const CellReport before = bench.check();
    EXPECT_THAT(failed_items(before), IsEmpty()) << text_of(before);
    EXPECT_EQ(item_of(before, "sweep").outcome, CheckOutcome::kSkipped);
    bench.warm_up();
    const CellReport after = bench.check();
    EXPECT_THAT(failed_items(after), IsEmpty()) << text_of(after);
    for (const CellCheckItem& item : after.items) {
        EXPECT_EQ(item.outcome, CheckOutcome::kPassed) << item.name << ": " << item.sentence;
    }
}
INSTANTIATE_TEST_SUITE_P(Seeds, HealthyCell, testing::Values(1, 2, 3));

TEST(CellCheckOnTheSimulatedCell, IsTheSameWhereTheJointTurnsTheOtherWay) {
    CellBench bench(1);
    bench.warm_up(-1.0);
    const CellReport report = bench.check();
    EXPECT_THAT(failed_items(report), IsEmpty()) << text_of(report);
    EXPECT_EQ(item_of(report, "sweep").outcome, CheckOutcome::kPassed);
}

TEST(CellCheckOnTheSimulatedCell, FindsAThingBeforeTheGripperAtOnceAndAfterTheWarmUp) {
    CellBench bench(1);
    const Eigen::Vector3d at_m =
        centre(bench.region) - Eigen::Vector3d(0.02, 0.0, 0.075);  // before the gripper
    bench.put({{0.02, 0.03, 0.008}, at_m});
    const CellReport before = bench.check();
    EXPECT_THAT(failed_items(before), ElementsAre("alone")) << text_of(before);
    bench.warm_up();
    const CellReport after = bench.check();
    EXPECT_THAT(failed_items(after), ElementsAre("alone")) << text_of(after);
}

TEST(CellCheckOnTheSimulatedCell, FindsThatTheRegionReachesIntoTheArm) {
    CellBench bench(2);
    bench.T_robot_camera = bench.layout.T_world_camera;
    EXPECT_THAT(failed_items(bench.check()), IsEmpty());
    bench.region.max_m.x() += 0.09;
    const CellReport aligned = bench.check();
    EXPECT_THAT(failed_items(aligned), ElementsAre("joint")) << text_of(aligned);
    bench.T_robot_camera.reset();
    bench.warm_up();
    const CellReport warmed_up = bench.check();
    EXPECT_THAT(failed_items(warmed_up), ElementsAre("joint")) << text_of(warmed_up);
}

TEST(CellCheckOnTheSimulatedCell, FindsThatTheGripperHasNoRoomToTurn) {
    CellBench bench(3);
    // The gripper reaches about 80 mm from the axis. A block 83 mm below it is outside a region
    // that ends at 81 mm, as somebody may have drawn it.
    const Axis axis = sim::joint6_axis_in_camera(bench.layout);
    const Eigen::Vector3d on_axis_m = axis.nearest_to(centre(bench.region));
    bench.put({{0.08, 0.04, 0.03}, on_axis_m + Eigen::Vector3d(-0.02, 0.083 + 0.02, 0.0)});
    bench.region.max_m.y() = on_axis_m.y() + 0.081;
    bench.warm_up();
    const CellReport report = bench.check();
    EXPECT_THAT(failed_items(report), ElementsAre("sweep")) << text_of(report);
}

TEST(CellCheckOnTheSimulatedCell, FindsEachOtherFaultAndNothingElse) {
    CellBench bench(1);
    const Box good = bench.region;

    bench.robot.controller.emergency_stop = true;
    bench.robot.controller.alarm = "SRVO-002";
    const CellReport stopped = bench.check();
    EXPECT_THAT(failed_items(stopped), ElementsAre("controller"));
    EXPECT_THAT(item_of(stopped, "controller").sentence, HasSubstr("SRVO-002"));
    bench.plan.mode = MotionMode::kDry;
    EXPECT_THAT(failed_items(bench.check()), IsEmpty());
    bench.plan.mode = MotionMode::kSim;
    bench.robot.controller.emergency_stop = false;

    bench.region = {good.min_m + Eigen::Vector3d(0.4, 0, 0),
                    good.max_m + Eigen::Vector3d(0.4, 0, 0)};
    const CellReport outside = bench.check();
    EXPECT_THAT(failed_items(outside), ElementsAre("volume")) << text_of(outside);
    EXPECT_EQ(item_of(outside, "surface").outcome, CheckOutcome::kSkipped);
    bench.region = good;

    bench.plan.start_joint6_rad = rad_from_deg(20.0);
    EXPECT_THAT(failed_items(bench.check()), ElementsAre("range", "cable"));
    bench.plan.start_joint6_rad.reset();

    bench.defocus(4.0);
    const CellReport blurred = bench.check();
    EXPECT_THAT(failed_items(blurred), ElementsAre("fill", "surface")) << text_of(blurred);
}

}  // namespace
}  // namespace gripscan::test
