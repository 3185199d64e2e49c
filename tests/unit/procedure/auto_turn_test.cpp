#include "core/procedure/auto_turn.h"

#include <gmock/gmock.h>

#include <numbers>
#include <vector>

#include "core/base/units.h"

namespace gripscan {
namespace {

using testing::HasSubstr;

/// Goes where it is told, a little beside it; stops short when `stuck_at` is reached.
class FakeRobot : public RobotLink {
  public:
    RobotResult<RobotIdentity> connect() override { return {}; }
    void disconnect() override {}
    RobotResult<ControllerState> state() override { return {}; }
    RobotResult<void> stop() override { return {}; }
    void on_beat(std::function<void(const RobotBeat&)>) override {}
    RobotResult<RobotReading> read() override { return reading(); }
    RobotResult<RobotReading> turn_joint6(const Joint6Command& command, std::stop_token) override {
        asked.push_back(command.angle_rad);
        if (asked.size() == fails_at) {
            return tl::unexpected<RobotError>(
                {RobotFault::kLost, 0, 0, "the robot's server is gone"});
        }
        if (asked.size() != stuck_at) joint6_ = command.angle_rad + 1e-4;
        return reading();
    }

    std::vector<double> asked;
    std::size_t stuck_at = 0;
    std::size_t fails_at = 0;

  private:
    RobotReading reading() const {
        RobotReading reading;
        reading.joints_rad[5] = joint6_;
        return reading;
    }
    double joint6_ = 0.0;
};

class FakeCamera : public StereoSource {
  public:
    Result<StereoFrame> grab(const FrameRequest& request) override {
        captures.push_back(request.capture);
        if (captures.size() == fails_at) return device_error("camera unplugged");
        return StereoFrame{cv::Mat(4, 4, CV_8UC1), cv::Mat(4, 4, CV_8UC1), 0.0};
    }
    std::vector<int> captures;
    std::size_t fails_at = 0;
};

class FakeStore : public TurnStore {
  public:
    Status store(const TakenCapture& capture) override {
        stored.push_back(capture);
        return {};
    }
    std::vector<TakenCapture> stored;
};

class FakeJournal : public Journal {
  public:
    Status write(std::string_view event, const JournalFields&) override {
        events.emplace_back(event);
        return {};
    }
    std::vector<std::string> events;
};

struct Cell {
    FakeRobot robot;
    FakeCamera camera;
    FakeStore store;
    FakeJournal journal;
    AutoTurnSettings settings{rad_from_deg(10.0), -std::numbers::pi, 2.0 * std::numbers::pi};

    Status turn(const Progress& progress = {}) {
        return take_turn(robot, camera, settings, store, journal, progress);
    }
};

TEST(AutoTurn, TenDegreesMakeThirtySevenCapturesAtAbsoluteAngles) {
    Cell cell;
    const Status taken = cell.turn();
    ASSERT_TRUE(taken) << taken.error().message;
    ASSERT_EQ(cell.store.stored.size(), 37u);
    for (std::size_t k = 0; k < 37; ++k) {
        EXPECT_NEAR(cell.robot.asked[k], rad_from_deg(-180.0 + 10.0 * static_cast<double>(k)),
                    1e-12);
        EXPECT_EQ(cell.store.stored[k].index, static_cast<int>(k));
        EXPECT_NEAR(cell.store.stored[k].commanded_rad, rad_from_deg(10.0 * static_cast<double>(k)),
                    1e-12);
    }
    EXPECT_EQ(cell.journal.events.size(), 3 * 37u) << "command, result, capture";
}

TEST(AutoTurn, StepsAreRoundedToAWholeTurn) {
    EXPECT_EQ(steps_of_turn(rad_from_deg(10.0)), 36);
    EXPECT_EQ(steps_of_turn(rad_from_deg(7.0)), 51);
    EXPECT_EQ(steps_of_turn(rad_from_deg(120.0)), 3);
}

TEST(AutoTurn, RefusesATurnBeyondTheJoint) {
    Cell cell;
    cell.settings.start_joint6_rad = rad_from_deg(10.0);
    const Status taken = cell.turn();
    ASSERT_FALSE(taken);
    EXPECT_THAT(taken.error().message, HasSubstr("beyond"));
    EXPECT_TRUE(cell.robot.asked.empty()) << "nothing has moved";
    for (const double step : {0.0, -0.1, 4.0}) {
        cell.settings.step_rad = step;
        EXPECT_FALSE(cell.turn());
    }
}

TEST(AutoTurn, ARobotThatStopsOnTheWayIsADeviceError) {
    Cell cell;
    cell.robot.stuck_at = 5;
    const Status taken = cell.turn();
    ASSERT_FALSE(taken);
    EXPECT_EQ(taken.error().kind, ErrorKind::kDevice);
    EXPECT_THAT(taken.error().message, HasSubstr("instead of -140.000"));
    EXPECT_EQ(cell.store.stored.size(), 4u) << "what was taken before is kept";
}

TEST(AutoTurn, PassesOnWhatTheDevicesSay) {
    Cell lost_robot;
    lost_robot.robot.fails_at = 3;
    EXPECT_EQ(lost_robot.turn().error().message, "the robot's server is gone");
    Cell lost_camera;
    lost_camera.camera.fails_at = 3;
    EXPECT_EQ(lost_camera.turn().error().message, "camera unplugged");
    EXPECT_EQ(lost_camera.store.stored.size(), 2u);
}

TEST(AutoTurn, StopsBeforeTheNextMotionWhenCancelled) {
    Cell cell;
    std::stop_source stop;
    Progress progress{stop.get_token(), [&](std::string_view, std::size_t done, std::size_t) {
                          if (done == 7) stop.request_stop();
                      }};
    const Status taken = cell.turn(progress);
    ASSERT_FALSE(taken);
    EXPECT_EQ(taken.error().kind, ErrorKind::kCancelled);
    EXPECT_EQ(cell.robot.asked.size(), 7u);
}

}  // namespace
}  // namespace gripscan
