#include "core/procedure/cell_effects.h"

#include <gmock/gmock.h>

#include "core/sim/sim_cell.h"
#include "tests/support/fake_work.h"
#include "tests/unit/procedure/cell_bench.h"

namespace gripscan::test {
namespace {

using testing::HasSubstr;

/// A robot that falls silent after so many readings.
class SilentRobot : public BenchRobot {
  public:
    SilentRobot() : BenchRobot(JointAngles{}) {}
    RobotResult<RobotReading> read() override {
        if (readings-- <= 0) {
            return tl::unexpected(RobotError{RobotFault::kTimeout, 0, 0, "no answer within 2 s"});
        }
        return BenchRobot::read();
    }
    int readings = 3;
};

struct NoResults : ResultKeeper {
    Status keep(const ComputedTurn&) override { return {}; }
};

/// The link is no item to be looked at and accepted: without it there is nothing to assess.
TEST(CellEffects, ARobotThatFallsSilentInterruptsTheCellCheck) {
    auto cell = SimCell::create({.image_fraction = 4, .time_scale = 200.0}).value();
    SilentRobot robot;
    MemoryStore store;
    NoResults results;
    auto workspace = TurnWorkspace::create(cell.rig(), cell.region(), {}).value();
    CellEffects effects({.robot = &robot,
                         .source = cell.source(),
                         .rig = cell.rig(),
                         .region = cell.region(),
                         .axis_hint = std::nullopt,
                         .T_robot_camera = std::nullopt,
                         .session = ".",
                         .exposure = {},
                         .differs = [](const auto&, const auto&) { return std::nullopt; }},
                        std::move(workspace), store, results, for_each_in_order);
    const Event silent = effects.run(effect::MeasureCell{}, {}, {});
    const auto* failed = std::get_if<event::WorkFailed>(&silent);
    ASSERT_NE(failed, nullptr);
    EXPECT_THAT(failed->why, HasSubstr("no answer within 2 s"));

    robot.readings = 1000;
    const Event answered = effects.run(effect::MeasureCell{}, {}, {});
    EXPECT_TRUE(std::holds_alternative<event::CellChecked>(answered));
}

}  // namespace
}  // namespace gripscan::test
