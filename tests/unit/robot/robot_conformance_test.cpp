// The conformance script passes on a controller that keeps to the protocol, and names what is wrong
// with one that does not.
#include "core/robot/robot_conformance.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/mock_bends.h"
#include "tests/unit/robot/conformance_run.h"

namespace gripscan::gsp {
namespace {

using std::chrono::milliseconds;
using test::MockController;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

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

TEST(RobotConformance, ACommandThatMustBeRefusedMovesNothingEvenIfItIsTaken) {
    MockController controller;
    controller.flaw(test::Flaw::kTurnsOnMonitor)
        .flaw(test::Flaw::kNoLimits)
        .hears(test::Side::kMotion, test::without_words_beyond(4));
    EXPECT_FALSE(report_of(controller, false).conforms());
    EXPECT_EQ(controller.arm().moves(), 0) << "without permission to move";
    controller.arm().shift_joint(5, 40.0);
    ASSERT_FALSE(report_of(controller, true).conforms());
    EXPECT_GE(controller.stops(), 3) << "whoever takes 400 deg is stopped at once";
    EXPECT_LT(controller.arm().joints_deg()[5], 360.0);
}

TEST(RobotConformance, IdsThatAreNearlyUsedUpAreTold) {
    MockController controller;
    controller.remembers(std::numeric_limits<int>::max());
    const ConformanceReport report = report_of(controller, true);
    EXPECT_THAT(names(report, CheckOutcome::kFailed), ElementsAre("move.ids"));
    EXPECT_THAT(failures(report), HasSubstr("used up"));
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

TEST(RobotConformance, APortThatAnotherClientHoldsIsAnErrorSoon) {
    for (const bool motion : {true, false}) {
        MockController controller;
        const auto port = motion ? controller.motion_port() : controller.monitor_port();
        auto holder =
            TcpConnection::connect("127.0.0.1", port, deadline_in(std::chrono::seconds(5)));
        ASSERT_TRUE(holder);
        const auto begin = std::chrono::steady_clock::now();
        const auto report = check_conformance(settings_of(controller, false), {}, {});
        EXPECT_LT(std::chrono::steady_clock::now() - begin, milliseconds(4000));
        ASSERT_FALSE(report);
        EXPECT_EQ(report.error().kind, ErrorKind::kDevice);
        EXPECT_THAT(report.error().message, HasSubstr(std::to_string(port)));
        EXPECT_THAT(report.error().message, HasSubstr(motion ? "(motion)" : "(monitor)"));
        EXPECT_THAT(report.error().message, HasSubstr("end the other client"));
    }
}

TEST(RobotConformance, AControllerThatSaysItIsBusyIsAnErrorSoon) {
    MockController controller;
    controller.says(test::Side::kMonitor, test::instead_of("OK HELLO", "ERR 0 303 one client"));
    const auto report = check_conformance(settings_of(controller, false), {}, {});
    ASSERT_FALSE(report);
    EXPECT_EQ(report.error().kind, ErrorKind::kDevice);
    EXPECT_THAT(report.error().message, HasSubstr("ERR 0 303 one client"));
}

/// Some other server: what it greets with is told, rather than that it is busy.
TEST(RobotConformance, APortThatSpeaksSomethingElseIsToldWithWhatItSays) {
    const auto told = [](const std::string& greeting) {
        TcpListener listener = TcpListener::open(0).value();
        const std::jthread server([&] {
            auto client = listener.accept({}, deadline_in(std::chrono::seconds(10)));
            if (!client) return;
            (void)client->write(greeting, deadline_in(std::chrono::seconds(10)));
            while (client->read_some(deadline_in(std::chrono::seconds(10)))) {
            }
        });
        ConformanceSettings settings;
        settings.motion_port = listener.port();
        settings.reply_limit = milliseconds(300);
        const auto report = check_conformance(settings, {}, {});
        EXPECT_FALSE(report);
        if (report) return std::string("conforms");
        EXPECT_EQ(report.error().kind, ErrorKind::kDevice);
        EXPECT_THAT(report.error().message, HasSubstr("no server of GSP/1"));
        return report.error().message;
    };
    EXPECT_THAT(told("SSH-2.0-x\r\n"), HasSubstr("'SSH-2.0-x'"));
    EXPECT_THAT(told(std::string("GSFP\0\1e", 7)), HasSubstr("'GSFP??e' and no end of a line"));
    EXPECT_THAT(told("\xFF\xFB\x01"), HasSubstr("byte 0xFF"));
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
