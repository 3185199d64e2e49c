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

/// A camera whose link is lost, or that refuses a picture.
struct LostCamera : StereoSource {
    explicit LostCamera(StereoSource& source) : camera(source) {}
    Result<StereoFrame> grab(const FrameRequest& request) override {
        if (lost) return device_error("camera at c:1 closed the connection");
        return camera.grab(request);
    }
    StereoSource& camera;
    bool lost = true;
};

struct NoResults : ResultKeeper {
    Status keep(const ComputedTurn&) override { return {}; }
};

class CellEffectsTest : public testing::Test {
  protected:
    CellEffects effects_with(RobotLink& robot, StereoSource& source) {
        auto workspace = TurnWorkspace::create(cell_.rig(), cell_.region(), {}).value();
        return {{.robot = &robot,
                 .source = source,
                 .rig = cell_.rig(),
                 .region = cell_.region(),
                 .axis_hint = std::nullopt,
                 .T_robot_camera = std::nullopt,
                 .session = ".",
                 .exposure = {},
                 .differs = [](const auto&, const auto&) { return std::nullopt; }},
                std::move(workspace),
                store_,
                results_,
                for_each_in_order};
    }
    /// Why the check was interrupted; empty: it was made.
    static std::string interruption(CellEffects& effects) {
        const Event event = effects.run(effect::MeasureCell{}, {}, {});
        const auto* failed = std::get_if<event::WorkFailed>(&event);
        EXPECT_NE(failed != nullptr, std::holds_alternative<event::CellChecked>(event));
        return failed != nullptr ? failed->why : "";
    }

    SimCell cell_ = SimCell::create({.image_fraction = 4, .time_scale = 200.0}).value();
    MemoryStore store_;
    NoResults results_;
};

/// The link is no item to be looked at and accepted: without it there is nothing to assess.
TEST_F(CellEffectsTest, ARobotThatFallsSilentInterruptsTheCellCheck) {
    SilentRobot robot;
    CellEffects effects = effects_with(robot, cell_.source());
    EXPECT_THAT(interruption(effects), HasSubstr("no answer within 2 s"));
    robot.readings = 1000;
    EXPECT_EQ(interruption(effects), "");
}

TEST_F(CellEffectsTest, ACameraThatIsLostInterruptsTheCellCheck) {
    SilentRobot robot;
    robot.readings = 1000;
    LostCamera camera(cell_.source());
    CellEffects effects = effects_with(robot, camera);
    EXPECT_THAT(interruption(effects), HasSubstr("camera at c:1 closed the connection"));
    camera.lost = false;
    EXPECT_EQ(interruption(effects), "");
}

}  // namespace
}  // namespace gripscan::test
