// The link to a controller that keeps to the protocol: what it reads, checks, refuses and stops.
#include "core/robot/gsp_link.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <future>

#include "core/robot/gsp_turn.h"
#include "tests/support/gsp_link_settings.h"

namespace gripscan::gsp {
namespace {

using std::chrono::milliseconds;
using test::Mischief;
using test::MockController;
using test::Point;
using testing::HasSubstr;

constexpr double kRounding_rad = rad_from_deg(5e-5);

Joint6Command turn_to(int id, double angle_deg, double speed_percent = 10.0) {
    return {id, rad_from_deg(angle_deg), speed_percent};
}

/// Waits for what another thread brings about; a test that waits in vain fails, it does not hang.
bool eventually(const std::function<bool()>& holds) {
    for (int i = 0; i < 2000; ++i) {
        if (holds()) return true;
        std::this_thread::sleep_for(milliseconds(5));
    }
    return false;
}

TEST(GspLink, ConnectsReadsAndTurns) {
    MockController controller;
    GspLink link(test::quick_settings(controller));
    const auto identity = link.connect();
    ASSERT_TRUE(identity) << identity.error().message;
    EXPECT_EQ(identity->model, "LRMate200iC/5L");
    EXPECT_EQ(identity->axes, 6);
    EXPECT_EQ(identity->protocol, "GSP/1.0");

    const auto state = link.state();
    ASSERT_TRUE(state);
    EXPECT_TRUE(state->automatic && state->servo_on);
    EXPECT_FALSE(state->moving || state->fault || state->emergency_stop);

    const auto turned = link.turn_joint6(turn_to(1, 30.0), {});
    ASSERT_TRUE(turned) << turned.error().message;
    EXPECT_NEAR(turned->joints_rad[5], rad_from_deg(30.0), kRounding_rad);
    // The pose of the golden table for 0 0 0 0 -90 30.
    EXPECT_NEAR(turned->T_world_tool.translation().x(), 0.485, 1e-6);
    EXPECT_NEAR(turned->T_world_tool.translation().z(), 0.395, 1e-6);
    const auto read = link.read();
    ASSERT_TRUE(read);
    EXPECT_EQ(read->joints_rad, turned->joints_rad);
}

TEST(GspLink, TheSameTurnAskedAgainMovesNothing) {
    MockController controller;
    GspLink link(test::quick_settings(controller));
    ASSERT_TRUE(link.connect());
    ASSERT_TRUE(link.turn_joint6(turn_to(1, 30.0), {}));
    ASSERT_TRUE(link.connect()) << "as after a restart of the program";
    ASSERT_TRUE(link.turn_joint6(turn_to(1, 30.0), {}));
    EXPECT_EQ(controller.arm().moves(), 1);
    const auto conflict = link.turn_joint6(turn_to(1, 31.0), {});
    ASSERT_FALSE(conflict);
    EXPECT_EQ(conflict.error().fault, RobotFault::kStaleId);
    EXPECT_EQ(conflict.error().last_id, 1);
}

TEST(GspLink, ChecksOnThisSideBeforeAnythingIsSent) {
    MockController controller;
    GspLink link(test::quick_settings(controller));
    ASSERT_TRUE(link.connect());
    struct Case {
        Joint6Command command;
        std::string words;
    };
    for (const auto& [command, words] : std::vector<Case>{
             {turn_to(0, 10.0), "id"},
             {turn_to(-5, 10.0), "id"},
             {turn_to(std::numeric_limits<int>::max(), 10.0), "id"},
             {turn_to(1, 10.0, 0.5), "speed"},
             {turn_to(1, 10.0, 31.0), "speed"},
             {turn_to(1, 10.0, std::nan("")), "speed"},
             {turn_to(1, 46.0), "step"},
             {turn_to(1, -46.0), "step"},
             {turn_to(1, 361.0), "joint 6"},
             {turn_to(1, std::nan("")), "joint 6"},
         }) {
        const auto refused = link.turn_joint6(command, {});
        ASSERT_FALSE(refused) << words;
        EXPECT_EQ(refused.error().fault, RobotFault::kOutOfRange);
        EXPECT_THAT(refused.error().message, HasSubstr(words));
    }
    EXPECT_EQ(controller.turns_received(), 0);
    EXPECT_TRUE(link.turn_joint6(turn_to(1, 45.0, 30.0), {})) << "the caps themselves are allowed";
}

TEST(GspLink, AnotherJointThatMovedMakesTheStepVoid) {
    MockController controller;
    GspLink link(test::quick_settings(controller));
    ASSERT_TRUE(link.connect());
    controller.turns_joint5_along(0.02);
    EXPECT_TRUE(link.turn_joint6(turn_to(1, 10.0), {})) << "within tolerance";
    controller.turns_joint5_along(0.1);
    const auto moved = link.turn_joint6(turn_to(2, 20.0), {});
    ASSERT_FALSE(moved);
    EXPECT_EQ(moved.error().fault, RobotFault::kOtherJoint);
    EXPECT_THAT(moved.error().message, HasSubstr("joint 5 moved by +0.1"));
}

TEST(GspLink, ATurnThatEndsElsewhereIsOffTarget) {
    MockController controller;
    GspLink link(test::quick_settings(controller));
    ASSERT_TRUE(link.connect());
    controller.reports_joint6_off(0.04);
    EXPECT_TRUE(link.turn_joint6(turn_to(1, 10.0), {}));
    controller.reports_joint6_off(-0.3);
    const auto off = link.turn_joint6(turn_to(2, 20.0), {});
    ASSERT_FALSE(off);
    EXPECT_EQ(off.error().fault, RobotFault::kOffTarget);
    EXPECT_THAT(off.error().message, HasSubstr("-0.3"));
}

TEST(GspLink, AStopRequestStopsTheArm) {
    MockController controller;
    controller.turns_for(std::chrono::seconds(60));
    auto settings = test::quick_settings(controller);
    settings.done_margin = std::chrono::minutes(2);
    GspLink link(settings);
    ASSERT_TRUE(link.connect());
    std::stop_source stop;
    auto outcome = std::async(std::launch::async,
                              [&] { return link.turn_joint6(turn_to(1, 30.0), stop.get_token()); });
    ASSERT_TRUE(eventually([&] { return controller.arm().moving(); }));
    stop.request_stop();
    const auto stopped = outcome.get();
    ASSERT_FALSE(stopped);
    EXPECT_EQ(stopped.error().fault, RobotFault::kStopped);
    EXPECT_EQ(stopped.error().code, 410);
    EXPECT_FALSE(controller.arm().moving());
    EXPECT_LT(controller.arm().travelled_deg(), 30.0);
    controller.turns_for(milliseconds(30));
    EXPECT_TRUE(link.turn_joint6(turn_to(2, 30.0), {})) << "the next may follow";
}

TEST(GspLink, StopFromAnotherThreadStopsTheArmToo) {
    MockController controller;
    controller.turns_for(std::chrono::seconds(60));
    auto settings = test::quick_settings(controller);
    settings.done_margin = std::chrono::minutes(2);
    GspLink link(settings);
    ASSERT_TRUE(link.connect());
    auto outcome =
        std::async(std::launch::async, [&] { return link.turn_joint6(turn_to(1, 30.0), {}); });
    ASSERT_TRUE(eventually([&] { return controller.arm().moving(); }));
    EXPECT_TRUE(link.stop());
    EXPECT_EQ(outcome.get().error().fault, RobotFault::kStopped);
}

TEST(GspLink, AStopRequestBeforeTheTurnSendsNothing) {
    MockController controller;
    GspLink link(test::quick_settings(controller));
    ASSERT_TRUE(link.connect());
    std::stop_source stop;
    stop.request_stop();
    const auto stopped = link.turn_joint6(turn_to(1, 30.0), stop.get_token());
    ASSERT_FALSE(stopped);
    EXPECT_EQ(stopped.error().fault, RobotFault::kStopped);
    EXPECT_EQ(controller.turns_received(), 0);
}

TEST(GspLink, ATurnThatWasStoppedWhileItsLinkWasDownIsNotSentAgain) {
    MockController controller;
    // The command is lost with the connection; then the program wants to stop.
    std::stop_source stop;
    controller.at(Point::kRequest, Mischief::kHalfOpen);
    GspLink link(test::quick_settings(controller));
    ASSERT_TRUE(link.connect());
    auto outcome = std::async(std::launch::async,
                              [&] { return link.turn_joint6(turn_to(1, 30.0), stop.get_token()); });
    ASSERT_TRUE(eventually([&] { return controller.turns_received() == 1; }));
    stop.request_stop();
    const auto stopped = outcome.get();
    ASSERT_FALSE(stopped);
    EXPECT_EQ(stopped.error().fault, RobotFault::kStopped) << stopped.error().message;
    EXPECT_EQ(controller.arm().moves(), 0);
    EXPECT_GE(controller.stops(), 1);
}

TEST(GspLink, CanBeReadFromManyThreadsDuringATurn) {
    MockController controller;
    controller.turns_for(milliseconds(200));
    GspLink link(test::quick_settings(controller));
    ASSERT_TRUE(link.connect());
    std::atomic<bool> turning = true;
    std::atomic<int> readings = 0, troubles = 0;
    std::vector<std::jthread> readers;
    for (int i = 0; i < 3; ++i) {
        readers.emplace_back([&] {
            while (turning) {
                const auto reading = link.read();
                ++(reading && link.state() ? readings : troubles);
            }
        });
    }
    EXPECT_TRUE(link.turn_joint6(turn_to(1, 30.0), {}));
    turning = false;
    readers.clear();
    EXPECT_EQ(troubles, 0);
    EXPECT_GT(readings, 0);
}

TEST(GspLink, TellsOfEveryBeatAndWhenTheyCease) {
    std::atomic<int> alive = 0, dead = 0;
    std::atomic<double> joint6_rad = 0.0;
    auto controller = std::make_unique<MockController>();
    GspLink link(test::quick_settings(*controller));
    link.on_beat([&](const RobotBeat& beat) {
        ++(beat.alive ? alive : dead);
        if (beat.alive) joint6_rad = beat.reading.joints_rad[5];
        EXPECT_EQ(beat.alive, beat.trouble.empty());
        EXPECT_GE(beat.round_trip_s, 0.0);
    });
    ASSERT_TRUE(link.connect());
    ASSERT_TRUE(link.turn_joint6(turn_to(1, 30.0), {}));
    EXPECT_TRUE(eventually([&] { return joint6_rad > rad_from_deg(29.9); }));
    controller.reset();
    EXPECT_TRUE(eventually([&] { return dead >= 2; }));
    link.disconnect();
    const int beats = alive + dead;
    std::this_thread::sleep_for(milliseconds(120));
    EXPECT_EQ(alive + dead, beats) << "none after disconnect()";
}

TEST(GspLink, WithoutMotionRightsItWatchesAndStopsBesideAnotherClient) {
    MockController controller;
    GspLink owner(test::quick_settings(controller));
    // The monitor, too, has room for one client only: the other keeps to its motion port.
    ASSERT_TRUE(TcpConnection::connect("127.0.0.1", controller.motion_port(),
                                       deadline_in(std::chrono::seconds(5))));
    auto settings = test::quick_settings(controller);
    settings.motion_rights = false;
    settings.motion_port = 1;  // nothing may depend on it
    GspLink watcher(settings);
    ASSERT_TRUE(watcher.connect());
    EXPECT_TRUE(watcher.read());
    EXPECT_TRUE(watcher.state());
    EXPECT_TRUE(watcher.stop());
    EXPECT_EQ(controller.stops(), 1);
    const auto refused = watcher.turn_joint6(turn_to(1, 10.0), {});
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().fault, RobotFault::kRefused);
    EXPECT_EQ(controller.turns_received(), 0);
}

TEST(GspLink, ConnectsOnlyToTheArmItIsMeantFor) {
    struct Case {
        HelloReply hello;
        std::string words;
    };
    for (const auto& [hello, words] :
         std::vector<Case>{{{"M-10iA", 6, "GSP/1.0"}, "M-10iA"},
                           {{"LRMate200iC/5L", 5, "GSP/1.0"}, "5 axes"},
                           {{"LRMate200iC/5L", 6, "GSP/2.0"}, "GSP/2.0"}}) {
        MockController controller;
        controller.introduces_itself_as(hello);
        GspLink link(test::quick_settings(controller));
        const auto identity = link.connect();
        ASSERT_FALSE(identity) << words;
        EXPECT_EQ(identity.error().fault, RobotFault::kUnreachable);
        EXPECT_THAT(identity.error().message, HasSubstr(words));
    }
    MockController controller;
    controller.introduces_itself_as({"M-10iA", 6, "GSP/1.1"});
    auto settings = test::quick_settings(controller);
    settings.model.clear();
    EXPECT_TRUE(GspLink(settings).connect()) << "any model, any minor version";
}

TEST(GspLink, SaysThatNobodyIsThereOrItIsNotConnected) {
    std::uint16_t port = 0;
    { port = TcpListener::open(0).value().port(); }
    GspSettings settings;
    settings.motion_port = port;
    GspLink link(settings);
    const auto nobody = link.connect();
    ASSERT_FALSE(nobody);
    EXPECT_EQ(nobody.error().fault, RobotFault::kUnreachable);
    EXPECT_THAT(nobody.error().message, HasSubstr(std::to_string(port)));
    EXPECT_EQ(link.read().error().fault, RobotFault::kUnreachable);
    EXPECT_EQ(link.state().error().fault, RobotFault::kUnreachable);
    EXPECT_EQ(link.stop().error().fault, RobotFault::kUnreachable);
    EXPECT_EQ(link.turn_joint6(turn_to(1, 1.0), {}).error().fault, RobotFault::kUnreachable);
}

TEST(GspLink, ConnectingAnewFindsThatALostTurnHasEnded) {
    MockController controller;
    controller.at(Point::kDone, Mischief::kDrop, 1000);
    auto settings = test::quick_settings(controller);
    settings.max_recoveries = 1;
    GspLink link(settings);
    ASSERT_TRUE(link.connect());
    ASSERT_TRUE(link.turn_joint6(turn_to(1, 30.0), {}).error().motion_unknown());
    EXPECT_EQ(link.turn_joint6(turn_to(2, 40.0), {}).error().fault, RobotFault::kRefused);
    controller.heals();
    ASSERT_TRUE(link.connect());
    EXPECT_TRUE(link.turn_joint6(turn_to(2, 40.0), {}));
}

TEST(GspLink, TheMotionTimeFollowsAngleSpeedAndOverride) {
    const GspSettings settings;
    EXPECT_EQ(motion_time(72.0, 10.0, 100, settings), milliseconds(1000));
    EXPECT_EQ(motion_time(-72.0, 10.0, 50, settings), milliseconds(2000));
    EXPECT_EQ(motion_time(72.0, 10.0, {}, settings), milliseconds(1000));
    EXPECT_EQ(motion_time(0.0, 10.0, 0, settings), milliseconds(0));
}

}  // namespace
}  // namespace gripscan::gsp
