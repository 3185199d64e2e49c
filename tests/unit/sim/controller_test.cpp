#include "core/sim/controller.h"

#include <gtest/gtest.h>

#include "core/base/units.h"
#include "core/robot/kinematics.h"

namespace gripscan::sim {
namespace {

using gsp::ErrorCode;
using gsp::TurnJoint6;

class ControllerTest : public ::testing::Test {
  protected:
    ArmMotion arm{{0, 0, 0, 0, rad_from_deg(-90), 0}, 3};
    Controller controller{arm, {}};
    double now_s = 10.0;

    gsp::Reply turn(int id, double angle_deg, double speed_percent = 50.0) {
        return controller.answer(LinkKind::kMotion, TurnJoint6{id, angle_deg, speed_percent},
                                 now_s);
    }
    gsp::Reply stop() { return controller.answer(LinkKind::kMonitor, gsp::Stop{}, now_s); }
    std::optional<gsp::Reply> outcome_after(double time_s) {
        now_s += time_s;
        return controller.outcome(now_s);
    }
    static ErrorCode code(const gsp::Reply& reply) { return std::get<gsp::Failure>(reply).code; }
    static bool accepted(const gsp::Reply& reply) {
        return std::holds_alternative<gsp::Accepted>(reply);
    }
};

TEST_F(ControllerTest, TurnsAndConfirmsOnceItStandsStill) {
    ASSERT_TRUE(accepted(turn(17, 30.0)));
    const double travel_s = arm.duration_s();
    EXPECT_FALSE(outcome_after(travel_s));
    EXPECT_FALSE(outcome_after(0.29));
    const auto end = outcome_after(0.02);
    ASSERT_TRUE(end);
    const auto done = std::get<gsp::Done>(*end);
    EXPECT_EQ(done.id, 17);
    EXPECT_NEAR(done.position.joints_deg[5].value(), 30.0, 0.03);
    EXPECT_EQ(done.position.uframe, 0);
    EXPECT_EQ(done.position.utool, 1);
    EXPECT_FALSE(outcome_after(10.0)) << "told once";
}

TEST_F(ControllerTest, ReportsTheToolOfItsEncoders) {
    // Golden: at 0 0 0 0 -90 30 the tool stands at 485 0 395 mm, turned by 180 0 30 deg.
    ASSERT_TRUE(accepted(turn(1, 30.0)));
    const auto end = outcome_after(5.0);
    ASSERT_TRUE(end);
    const auto position = std::get<gsp::Done>(*end).position;
    const double j6_deg = position.joints_deg[5].value();
    const std::array<double, 6> golden = {485.0, 0.0, 395.0, 180.0, 0.0, j6_deg};
    for (std::size_t i = 0; i < 6; ++i) {
        const double value = position.xyzwpr[i].value();
        EXPECT_NEAR(i == 3 ? std::abs(value) : value, golden[i], 1e-6) << i;
    }
}

TEST_F(ControllerTest, AnswersAnIdThatIsSentAgainWithoutMoving) {
    ASSERT_TRUE(accepted(turn(17, 30.0)));
    ASSERT_TRUE(accepted(turn(17, 30.0))) << "still running";
    const auto first = outcome_after(5.0);
    ASSERT_TRUE(first);
    controller.new_client();
    const double stands_rad = arm.at(now_s).true_rad[5];
    ASSERT_TRUE(accepted(turn(17, 30.0)));
    const auto second = outcome_after(0.0);
    ASSERT_TRUE(second);
    EXPECT_EQ(encode(*first), encode(*second)) << "stored, not measured again";
    EXPECT_EQ(arm.at(now_s + 0.1).true_rad[5], stands_rad);
    EXPECT_FALSE(arm.at(now_s + 0.1).moving);
}

TEST_F(ControllerTest, TellsANewClientNothingItDidNotAskFor) {
    ASSERT_TRUE(accepted(turn(17, 30.0)));
    controller.new_client();
    EXPECT_FALSE(outcome_after(5.0));
    ASSERT_TRUE(accepted(turn(17, 30.0)));
    EXPECT_TRUE(outcome_after(0.0));
}

TEST_F(ControllerTest, RefusesPassedAndConflictingIdsAndSaysTheLast) {
    ASSERT_TRUE(accepted(turn(17, 30.0)));
    ASSERT_TRUE(outcome_after(5.0));
    for (const auto& reply : {turn(16, 30.0), turn(17, 31.0), turn(17, 30.0, 20.0), turn(1, 0.0)}) {
        EXPECT_EQ(code(reply), ErrorCode::kStaleId);
        EXPECT_EQ(gsp::last_id_in(std::get<gsp::Failure>(reply).text), 17);
    }
    EXPECT_FALSE(arm.at(now_s).moving);
    EXPECT_TRUE(accepted(turn(18, 40.0)));
}

TEST_F(ControllerTest, IsBusyWithOneTurnOnly) {
    ASSERT_TRUE(accepted(turn(17, 30.0)));
    EXPECT_EQ(code(turn(18, 40.0)), ErrorCode::kBusy);
    ASSERT_TRUE(outcome_after(5.0));
    EXPECT_NEAR(deg_from_rad(arm.at(now_s).encoder_rad[5]), 30.0, 0.03);
    EXPECT_TRUE(accepted(turn(18, 40.0))) << "a refused id is not spent";
}

TEST_F(ControllerTest, RefusesWhatIsBeyondALimitAndStays) {
    EXPECT_EQ(code(turn(1, 360.5)), ErrorCode::kTargetRange);
    EXPECT_EQ(code(turn(1, 30.0, 0.5)), ErrorCode::kSpeedRange);
    EXPECT_EQ(code(turn(1, 30.0, 101.0)), ErrorCode::kSpeedRange);
    ASSERT_TRUE(accepted(turn(1, -300.0)));
    ASSERT_TRUE(outcome_after(9.0));
    EXPECT_EQ(code(turn(2, 100.0)), ErrorCode::kStepCap);
    controller.limit_joint6(5.0, now_s);
    EXPECT_EQ(code(turn(2, -290.0)), ErrorCode::kTargetRange);
    EXPECT_TRUE(accepted(turn(2, -296.0)));
}

TEST_F(ControllerTest, StopEndsTheTurnWhereItIs) {
    ASSERT_TRUE(accepted(turn(5, 90.0)));
    now_s += arm.duration_s() / 2.0;
    EXPECT_TRUE(std::holds_alternative<gsp::StopReply>(stop()));
    const auto end = outcome_after(0.0);
    ASSERT_TRUE(end);
    EXPECT_EQ(code(*end), ErrorCode::kStopped);
    EXPECT_EQ(std::get<gsp::Failure>(*end).id, 5);
    EXPECT_NEAR(deg_from_rad(arm.at(now_s + 9.0).encoder_rad[5]), 45.0, 0.1);
    EXPECT_TRUE(std::holds_alternative<gsp::StopReply>(stop())) << "standing, too";
}

TEST_F(ControllerTest, LinksHaveTheirOwnRequests) {
    EXPECT_EQ(code(controller.answer(LinkKind::kMonitor, TurnJoint6{1, 5.0, 10.0}, now_s)),
              ErrorCode::kUnknownRequest);
    EXPECT_EQ(code(controller.answer(LinkKind::kMotion, gsp::Stop{}, now_s)),
              ErrorCode::kUnknownRequest);
    for (const LinkKind link : {LinkKind::kMotion, LinkKind::kMonitor}) {
        EXPECT_EQ(encode(controller.answer(link, gsp::Hello{1}, now_s)),
                  "OK HELLO LRMate200iC/5L 6 GSP/1.0");
        EXPECT_EQ(code(controller.answer(link, gsp::Hello{2}, now_s)), ErrorCode::kVersion);
        EXPECT_EQ(encode(controller.answer(link, gsp::AskState{}, now_s)),
                  "OK STATE 1 1 0 0 0 100 -");
    }
}

TEST_F(ControllerTest, ConditionsRefuseAndInterrupt) {
    const std::pair<Conditions, ErrorCode> cases[] = {
        {{.automatic = false}, ErrorCode::kNotAutomatic},
        {{.servo_on = false}, ErrorCode::kServoOff},
        {{.emergency_stop = true}, ErrorCode::kEmergencyStop},
        {{.fault = true, .alarm = "SRVO-050 collision"}, ErrorCode::kFault},
        {{.pendant_enabled = true}, ErrorCode::kPendant}};
    int id = 0;
    for (const auto& [conditions, expected] : cases) {
        controller.set_conditions(conditions, now_s);
        EXPECT_EQ(code(turn(id + 1, 10.0)), expected);
        controller.set_conditions({}, now_s);
        ++id;
        ASSERT_TRUE(accepted(turn(id, id % 2 == 0 ? 90.0 : -90.0)));
        now_s += arm.duration_s() / 2.0;
        controller.set_conditions(conditions, now_s, 2.0);
        const auto end = outcome_after(0.0);
        ASSERT_TRUE(end);
        EXPECT_EQ(code(*end), expected);
        EXPECT_FALSE(arm.at(now_s).moving);
        now_s += 2.1;
        EXPECT_EQ(encode(controller.answer(LinkKind::kMonitor, gsp::AskState{}, now_s)),
                  "OK STATE 1 1 0 0 0 100 -")
            << "as usual again";
    }
}

TEST_F(ControllerTest, ARestartForgetsIdsAndStopsTheArm) {
    ASSERT_TRUE(accepted(turn(17, 90.0)));
    now_s += arm.duration_s() / 2.0;
    controller.restart(now_s);
    EXPECT_FALSE(arm.at(now_s).moving);
    EXPECT_FALSE(outcome_after(9.0));
    EXPECT_TRUE(accepted(turn(1, 0.0)));
}

TEST(Controller, ATurnThatTakesTooLongEnds) {
    ArmMotion arm({}, 1);
    Controller controller(arm, {.max_turn_s = 0.5});
    (void)controller.answer(LinkKind::kMotion, TurnJoint6{1, 90.0, 1.0}, 0.0);
    const auto end = controller.outcome(0.6);
    ASSERT_TRUE(end);
    EXPECT_EQ(std::get<gsp::Failure>(*end).code, ErrorCode::kMotionTime);
    EXPECT_FALSE(arm.at(0.6).moving);
}

}  // namespace
}  // namespace gripscan::sim
