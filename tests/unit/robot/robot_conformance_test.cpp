// The conformance script passes on a controller that keeps to the protocol, and names what is wrong
// with one that does not.
#include "core/robot/robot_conformance.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/mock_controller.h"

namespace gripscan::gsp {
namespace {

using std::chrono::milliseconds;
using test::Mischief;
using test::MockController;
using test::Point;
using testing::Contains;
using testing::HasSubstr;
using testing::IsEmpty;

ConformanceSettings settings_of(const MockController& controller, bool move) {
    ConformanceSettings settings;
    settings.motion_port = controller.motion_port();
    settings.monitor_port = controller.monitor_port();
    settings.move = move;
    settings.reply_limit = milliseconds(400);
    settings.motion_limit = milliseconds(5000);
    settings.split_pause = milliseconds(10);
    return settings;
}

ConformanceReport report_of(MockController& controller, bool move) {
    controller.turns_for(milliseconds(150));
    auto report = check_conformance(settings_of(controller, move), {}, {});
    EXPECT_TRUE(report);
    return report ? *report : ConformanceReport{};
}

std::vector<std::string> names(const ConformanceReport& report, CheckOutcome outcome) {
    std::vector<std::string> result;
    for (const auto& check : report.checks) {
        if (check.outcome == outcome) result.push_back(check.name);
    }
    return result;
}

std::string failures(const ConformanceReport& report) {
    std::string text;
    for (const auto& check : report.checks) {
        if (check.outcome != CheckOutcome::kFailed) continue;
        text += fmt::format("{}: {} (required: {})\n", check.name, check.seen, check.required);
    }
    return text;
}

TEST(RobotConformance, AControllerThatKeepsToTheProtocolConforms) {
    MockController controller;
    const ConformanceReport report = report_of(controller, true);
    EXPECT_TRUE(report.conforms()) << failures(report);
    EXPECT_THAT(names(report, CheckOutcome::kSkipped), IsEmpty());
    EXPECT_NEAR(controller.arm().joints_deg()[5], 0.0, 1e-9) << "it is where it was";
}

TEST(RobotConformance, ItGoesOnFromTheLastId) {
    MockController controller;
    controller.remembers(1234);
    const ConformanceReport report = report_of(controller, true);
    EXPECT_TRUE(report.conforms()) << failures(report);
    EXPECT_THAT(names(report, CheckOutcome::kSkipped), IsEmpty());
}

TEST(RobotConformance, NothingMovesUnlessItMay) {
    MockController controller;
    const ConformanceReport report = report_of(controller, false);
    EXPECT_TRUE(report.conforms()) << failures(report);
    EXPECT_EQ(controller.arm().moves(), 0);
    EXPECT_THAT(names(report, CheckOutcome::kSkipped), Contains("move.turn"));
}

TEST(RobotConformance, EveryCheckIsTold) {
    MockController controller;
    int told = 0;
    const auto report = check_conformance(settings_of(controller, false),
                                          [&](const ConformanceCheck& check) {
                                              ++told;
                                              EXPECT_FALSE(check.name.empty());
                                              EXPECT_FALSE(check.required.empty());
                                          },
                                          {});
    ASSERT_TRUE(report);
    EXPECT_EQ(static_cast<std::size_t>(told), report->checks.size());
}

// Controllers that are broken on purpose, and the check that has to find it.

struct Broken {
    std::string check;
    std::function<void(MockController&)> how;
};

class BrokenController : public testing::TestWithParam<Broken> {};

TEST_P(BrokenController, IsFoundOut) {
    MockController controller;
    GetParam().how(controller);
    const ConformanceReport report = report_of(controller, GetParam().check.starts_with("move."));
    EXPECT_FALSE(report.conforms());
    EXPECT_THAT(names(report, CheckOutcome::kFailed), Contains(GetParam().check))
        << failures(report);
}

INSTANTIATE_TEST_SUITE_P(
    Every, BrokenController,
    testing::Values(
        Broken{"hello.motion",
               [](MockController& c) {
                   c.introduces_itself_as({"LRMate", 5, "GSP/1.0"});
               }},
        Broken{"hello.monitor",
               [](MockController& c) {
                   c.introduces_itself_as({"LRMate", 6, "XYZ/9"});
               }},
        Broken{"state", [](MockController& c) { c.at(Point::kQuestion, Mischief::kGarbled); }},
        Broken{"position", [](MockController& c) { c.flaw(test::Flaw::kShortPosition); }},
        Broken{"hello.version", [](MockController& c) { c.flaw(test::Flaw::kAnyVersion); }},
        Broken{"unknown", [](MockController& c) { c.flaw(test::Flaw::kSilentOnUnknown); }},
        Broken{"frame.long", [](MockController& c) { c.flaw(test::Flaw::kClosesOnLong); }},
        Broken{"frame.endless", [](MockController& c) { c.flaw(test::Flaw::kBearsAll); }},
        Broken{"move.repeat", [](MockController& c) { c.flaw(test::Flaw::kRepeatMoves); }},
        Broken{"move.stale", [](MockController& c) { c.flaw(test::Flaw::kForgetsIds); }},
        Broken{"move.conflict", [](MockController& c) { c.flaw(test::Flaw::kForgetsIds); }},
        Broken{"move.busy", [](MockController& c) { c.flaw(test::Flaw::kNeverBusy); }},
        Broken{"move.stop", [](MockController& c) { c.flaw(test::Flaw::kDeafToStop); }},
        Broken{"move.range", [](MockController& c) { c.flaw(test::Flaw::kNoLimits); }},
        Broken{"move.speed", [](MockController& c) { c.flaw(test::Flaw::kNoLimits); }},
        Broken{"move.ids", [](MockController& c) { c.reports_joint6_off(0.3); }},
        Broken{"move.others", [](MockController& c) { c.turns_joint5_along(0.1); }},
        Broken{"move.pose", [](MockController& c) { c.flaw(test::Flaw::kPoseStands); }},
        Broken{"move.lost", [](MockController& c) { c.flaw(test::Flaw::kForgetsOnLoss); }},
        Broken{"move.watch", [](MockController& c) { c.flaw(test::Flaw::kNeverTellsMoving); }}),
    [](const auto& test) {
        std::string name = test.param.check;
        std::replace(name.begin(), name.end(), '.', '_');
        return name + "_" + std::to_string(test.index);
    });

TEST(RobotConformance, AControllerThatIsNotReadyIsNotMoved) {
    MockController controller;
    controller.flaw(test::Flaw::kServoOff);
    const ConformanceReport report = report_of(controller, true);
    EXPECT_THAT(names(report, CheckOutcome::kFailed), Contains("move.ready"));
    EXPECT_THAT(names(report, CheckOutcome::kSkipped), Contains("move.turn"));
    EXPECT_EQ(controller.arm().moves(), 0);
}

TEST(RobotConformance, APortThatCannotBeReachedIsAnError) {
    ConformanceSettings settings;
    { settings.motion_port = TcpListener::open(0).value().port(); }
    const auto report = check_conformance(settings, {}, {});
    ASSERT_FALSE(report);
    EXPECT_EQ(report.error().kind, ErrorKind::kDevice);
    EXPECT_THAT(report.error().message, HasSubstr(std::to_string(settings.motion_port)));
}

TEST(RobotConformance, AStopRequestEndsIt) {
    MockController controller;
    std::stop_source stop;
    int told = 0;
    const auto report = check_conformance(
        settings_of(controller, true),
        [&](const ConformanceCheck&) {
            if (++told == 3) stop.request_stop();
        },
        stop.get_token());
    ASSERT_FALSE(report);
    EXPECT_EQ(report.error().kind, ErrorKind::kCancelled);
    EXPECT_EQ(told, 3);
}

}  // namespace
}  // namespace gripscan::gsp
