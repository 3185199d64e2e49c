// Every fault at every point of a turn, once, over real sockets. Whatever happens, joint 6 is
// turned by what was asked and no more.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/gsp_link_settings.h"
#include "tests/unit/robot/one_turn.h"
#include "tests/unit/robot/printers.h"

namespace gripscan::gsp {
namespace {

using test::Mischief;
using test::MockController;
using test::Point;
using testing::HasSubstr;

// One fault, then all is well: the turn is made, once.

struct Case {
    Point point;
    Mischief mischief;
    bool only_when_still;  ///< the controller takes a new client only once the arm stands
};

std::vector<Case> all_cases() {
    std::vector<Case> cases;
    for (const bool only_when_still : {false, true}) {
        for (const Mischief m :
             {Mischief::kDrop, Mischief::kHalfOpen, Mischief::kNever, Mischief::kRestart}) {
            cases.push_back({Point::kRequest, m, only_when_still});
        }
        for (const Mischief m : {Mischief::kDrop, Mischief::kHalfOpen, Mischief::kRestart}) {
            cases.push_back({Point::kMoving, m, only_when_still});
        }
        for (const Point point : {Point::kAccepted, Point::kDone}) {
            for (const Mischief m :
                 {Mischief::kDrop, Mischief::kHalfOpen, Mischief::kNever, Mischief::kLate,
                  Mischief::kGarbled, Mischief::kSplit, Mischief::kJoined, Mischief::kTwice,
                  Mischief::kBabble, Mischief::kRestart}) {
                cases.push_back({point, m, only_when_still});
            }
        }
    }
    return cases;
}

class OneFault : public testing::TestWithParam<Case> {};

TEST_P(OneFault, IsHealedAndTheJointIsTurnedOnce) {
    const Case& now = GetParam();
    MockController controller;
    if (now.only_when_still) controller.takes_clients_only_when_still();
    controller.at(now.point, now.mischief);
    GspLink link(test::quick_settings(controller));
    ASSERT_TRUE(link.connect());
    expect_arrived(link.turn_joint6(kTurn, {}), controller);
    // The link is of use afterwards, for the same and for the next.
    expect_arrived(link.turn_joint6(kTurn, {}), controller);
    const auto next = link.turn_joint6(kNext, {});
    ASSERT_TRUE(next) << next.error().message;
    EXPECT_NEAR(controller.arm().travelled_deg(), 2 * kTarget_deg, 1e-9);
}

TEST(GspFaults, AGreetingThatFailsWhileTheLinkIsFoundAgainIsHealedToo) {
    for (const Point point : {Point::kHello, Point::kMonitorHello}) {
        for (const Mischief m : {Mischief::kDrop, Mischief::kHalfOpen, Mischief::kNever,
                                 Mischief::kLate, Mischief::kGarbled, Mischief::kSplit,
                                 Mischief::kTwice, Mischief::kRestart, Mischief::kBabble}) {
            SCOPED_TRACE(name_of(point) + name_of(m));
            MockController controller;
            GspLink link(test::quick_settings(controller));
            ASSERT_TRUE(link.connect());
            controller.at(Point::kAccepted, Mischief::kDrop)
                .at(Point::kQuestion, Mischief::kDrop)
                .at(point, m);
            auto outcome = link.turn_joint6(kTurn, {});
            if (!outcome && point == Point::kMonitorHello) {
                // Two losses in a row are more than a question before a turn bears.
                EXPECT_FALSE(outcome.error().motion_unknown());
                EXPECT_EQ(controller.turns_received(), 0);
                outcome = link.turn_joint6(kTurn, {});
            }
            expect_arrived(outcome, controller);
        }
    }
}

INSTANTIATE_TEST_SUITE_P(EveryPoint, OneFault, testing::ValuesIn(all_cases()),
                         [](const auto& test) {
                             return name_of(test.param.point) + name_of(test.param.mischief) +
                                    (test.param.only_when_still ? "Blocking" : "");
                         });

// What the controller says of itself: passed on, nothing repeated.

TEST(GspFaults, EveryRefusalIsPassedOnAndNothingMoves) {
    for (const ErrorRow& row : error_table()) {
        if (row.code == ErrorCode::kStaleId) continue;
        MockController controller;
        controller.fails(Point::kRequest, row.code);
        GspLink link(test::quick_settings(controller));
        ASSERT_TRUE(link.connect());
        const auto refused = link.turn_joint6(kTurn, {});
        ASSERT_FALSE(refused) << row.words;
        EXPECT_EQ(refused.error().fault, row.fault);
        EXPECT_EQ(refused.error().code, static_cast<int>(row.code));
        EXPECT_THAT(refused.error().message, HasSubstr(std::string(row.words)));
        EXPECT_EQ(controller.arm().moves(), 0);
        EXPECT_EQ(controller.turns_received(), 1) << "a refusal is an outcome";
        EXPECT_TRUE(link.turn_joint6(kNext, {})) << "and the next id may follow";
    }
}

TEST(GspFaults, AnAlarmOnTheWayEndsTheTurnWithItsText) {
    MockController controller;
    controller.fails(Point::kMoving, ErrorCode::kFault);
    GspLink link(test::quick_settings(controller));
    ASSERT_TRUE(link.connect());
    const auto failed = link.turn_joint6(kTurn, {});
    ASSERT_FALSE(failed);
    EXPECT_EQ(failed.error().code, 203);
    EXPECT_THAT(failed.error().message, HasSubstr("SRVO-002"));
    EXPECT_LE(controller.arm().travelled_deg(), kTarget_deg);
}

TEST(GspFaults, AStoredFailureIsTheAnswerOfARepeatedTurnToo) {
    MockController controller;
    controller.fails(Point::kDone, ErrorCode::kOffTarget).at(Point::kDone, Mischief::kDrop);
    GspLink link(test::quick_settings(controller));
    ASSERT_TRUE(link.connect());
    const auto failed = link.turn_joint6(kTurn, {});
    ASSERT_FALSE(failed);
    EXPECT_EQ(failed.error().fault, RobotFault::kOffTarget);
    EXPECT_EQ(failed.error().code, 411);
    EXPECT_NEAR(controller.arm().travelled_deg(), kTarget_deg, 1e-9);
}

TEST(GspFaults, AStaleIdTellsWhereToGoOn) {
    MockController controller;
    controller.remembers(40);
    GspLink link(test::quick_settings(controller));
    ASSERT_TRUE(link.connect());
    const auto stale = link.turn_joint6(kTurn, {});
    ASSERT_FALSE(stale);
    EXPECT_EQ(stale.error().fault, RobotFault::kStaleId);
    EXPECT_EQ(stale.error().last_id, 40);
    EXPECT_EQ(controller.arm().moves(), 0);
    EXPECT_TRUE(link.turn_joint6({41, kTurn.angle_rad, 10.0}, {}));
}

TEST(GspFaults, TheMonitorIsAskedAgainWhenItsReplyGetsLost) {
    for (const Mischief m :
         {Mischief::kDrop, Mischief::kHalfOpen, Mischief::kNever, Mischief::kLate,
          Mischief::kGarbled, Mischief::kSplit, Mischief::kTwice, Mischief::kBabble}) {
        MockController controller;
        auto settings = test::quick_settings(controller);
        settings.beat_period = std::chrono::minutes(1);
        GspLink link(settings);
        ASSERT_TRUE(link.connect());
        ASSERT_TRUE(link.state());  // the first beat is over by then or behind it
        controller.at(Point::kQuestion, m);
        for (int i = 0; i < 3; ++i) {
            const auto reading = link.read();
            ASSERT_TRUE(reading) << name_of(m) << ": " << reading.error().message;
            EXPECT_NEAR(reading->joints_rad[4], rad_from_deg(-90.0), kRounding_rad);
        }
    }
}

TEST(GspFaults, AMonitorReplyThatComesTooLateIsNotTakenForTheNext) {
    MockController controller;
    auto settings = test::quick_settings(controller);
    settings.beat_period = std::chrono::minutes(1);
    GspLink link(settings);
    ASSERT_TRUE(link.connect());
    ASSERT_TRUE(link.state());
    controller.at(Point::kQuestion, Mischief::kLate);
    (void)link.read();
    controller.arm().shift_joint(5, 7.0);
    auto reading = link.read();
    for (int i = 0; i < 10 && !reading; ++i) reading = link.read();
    ASSERT_TRUE(reading) << reading.error().message;
    EXPECT_NEAR(reading->joints_rad[5], rad_from_deg(7.0), kRounding_rad);
}

TEST(GspFaults, ATurnSurvivesTroubleOfTheMonitor) {
    for (const Mischief m :
         {Mischief::kDrop, Mischief::kHalfOpen, Mischief::kNever, Mischief::kGarbled}) {
        MockController controller;
        GspLink link(test::quick_settings(controller));
        ASSERT_TRUE(link.connect());
        controller.at(Point::kQuestion, m).at(Point::kAccepted, Mischief::kDrop);
        expect_arrived(link.turn_joint6(kTurn, {}), controller);
    }
}

}  // namespace
}  // namespace gripscan::gsp
