// A turn as an operator drives it: what each command leads to.
#include <gmock/gmock.h>

#include "tests/unit/procedure/step_bench.h"

namespace gripscan {
namespace {

using test::accepted_row;
using test::Bench;
using test::deg;
using test::rejected_row;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

TEST(Step, RunTakesAWholeTurnByItselfAndGoesHome) {
    Bench bench;
    bench.command(command::Connect{});
    ASSERT_TRUE(bench.command(command::Run{}));
    ASSERT_TRUE(bench.in<phase::Finished>());
    EXPECT_FALSE(bench.state.running);
    EXPECT_EQ(bench.state.data.used().size(), 37U);
    EXPECT_EQ(table_of(bench.state).size(), 36U);
    EXPECT_NEAR(bench.cell.joint6_rad, deg(-180.0), 1e-12) << "the cable is unwound";
    EXPECT_EQ(bench.cell.shots.size(), 3U + 37U);
    for (std::size_t k = 0; k < 37; ++k) {
        EXPECT_NEAR(bench.state.data.captures[k].commanded_rad, deg(10.0 * static_cast<double>(k)),
                    1e-9);
        EXPECT_EQ(bench.state.data.captures[k].index, static_cast<int>(k));
    }
}

TEST(Step, ManualSteppingOffersOneNextAction) {
    Bench bench;
    EXPECT_EQ(word(*next_action(bench.state)), word(Command{command::Connect{}}));
    bench.command(command::Connect{});
    EXPECT_EQ(word(*next_action(bench.state)), word(Command{command::CheckCell{}}));
    bench.command(command::CheckCell{});
    EXPECT_EQ(word(*next_action(bench.state)), word(Command{command::WarmUp{}}));
    bench.command(command::WarmUp{});
    EXPECT_EQ(word(*next_action(bench.state)), word(Command{command::Capture{}}));
    bench.command(command::Capture{});
    EXPECT_EQ(word(*next_action(bench.state)), word(Command{command::Step{}}));
    EXPECT_FALSE(bench.state.running);
}

TEST(Step, AFailedCellCheckBlocksCaptureUntilItIsAcceptedWithANote) {
    Bench bench;
    bench.work.report = test::failed_report();
    bench.command(command::Connect{});
    bench.command(command::CheckCell{});
    EXPECT_FALSE(bench.command(command::Capture{}));
    EXPECT_THAT(bench.refused, HasSubstr("cell check has failed"));
    EXPECT_FALSE(bench.command(command::Accept{""})) << "a note is wanted";
    EXPECT_FALSE(bench.command(command::Accept{" \t"})) << "blanks say nothing";
    ASSERT_TRUE(bench.command(command::Accept{"the range is enough for half a turn"}));
    EXPECT_TRUE(bench.command(command::Capture{}));
    bench.state.running = false;
}

TEST(Step, ARunStopsAtAFailedCellCheck) {
    Bench bench;
    bench.work.report = test::failed_report();
    bench.command(command::Connect{});
    bench.command(command::Run{});
    EXPECT_FALSE(bench.state.running);
    EXPECT_TRUE(bench.in<phase::Idle>());
    EXPECT_THAT(bench.cell.motions_rad, IsEmpty());
}

TEST(Step, RetryTakesTheSameAngleAgainAndSupersedesTheFirst) {
    Bench bench;
    bench.first_steps(2);
    ASSERT_TRUE(bench.command(command::Retry{}));
    ASSERT_EQ(bench.state.data.captures.size(), 4U);
    EXPECT_EQ(bench.state.data.captures[2].status, CaptureStatus::kSuperseded);
    EXPECT_EQ(bench.state.data.captures[3].attempt, 2);
    EXPECT_EQ(bench.state.data.captures[3].index, 3) << "never renumbered";
    EXPECT_THAT(bench.used_deg(), ElementsAre(0, 10, 20));
}

TEST(Step, HalveGoesBackHalfAStepAndLaterStepsAreSmaller) {
    Bench bench;
    bench.first_steps(2);
    ASSERT_TRUE(bench.command(command::Halve{}));
    EXPECT_THAT(bench.used_deg(), ElementsAre(0, 10, 15));
    bench.command(command::Step{});
    EXPECT_THAT(bench.used_deg(), ElementsAre(0, 10, 15, 20));
    ASSERT_TRUE(bench.command(command::Halve{}));
    EXPECT_FALSE(bench.command(command::Halve{})) << "1.25 deg is below the least step";
    EXPECT_THAT(bench.refused, HasSubstr("least step"));
}

TEST(Step, ARejectedStepIsDecidedUponAndTheAdviceCanBeFollowed) {
    Bench bench;
    bench.work.judge = [](const CaptureRecord& from, const CaptureRecord& to) {
        const double turn = to.commanded_rad - from.commanded_rad;
        return turn > deg(6.0) ? rejected_row(from.index, to.index, turn, Cause::kOverlap)
                               : accepted_row(from.index, to.index, turn);
    };
    bench.first_steps(1);
    ASSERT_TRUE(bench.in<phase::Deciding>());
    EXPECT_EQ(bench.advised(), AdvisedAction::kHalve);
    EXPECT_EQ(word(*next_action(bench.state)), word(Command{command::Halve{}}));
    ASSERT_TRUE(bench.command(command::Halve{}));
    EXPECT_TRUE(bench.in<phase::Idle>());
    EXPECT_THAT(bench.used_deg(), ElementsAre(0, 5));
}

TEST(Step, AcceptWantsANoteAndTurnsTheVerdict) {
    Bench bench;
    bench.work.judge = [](const CaptureRecord& from, const CaptureRecord& to) {
        return rejected_row(from.index, to.index, deg(10.0), Cause::kBacklash);
    };
    bench.first_steps(1);
    EXPECT_FALSE(bench.command(command::Accept{""}));
    EXPECT_FALSE(bench.command(command::Accept{" \t"})) << "blanks say nothing";
    ASSERT_TRUE(bench.command(command::Accept{"play of the old gearbox, seen on the dial"}));
    EXPECT_TRUE(bench.in<phase::Idle>());
    const auto table = table_of(bench.state);
    EXPECT_EQ(table.back().row.verdict, Verdict::kAcceptNoted);
    EXPECT_THAT(table.back().row.sentence, HasSubstr("old gearbox"));
    bench.command(command::Undo{});
    EXPECT_TRUE(bench.in<phase::Deciding>()) << "the step is open again";
}

TEST(Step, UndoAndRedoAreInverseAndLoseNoCapture) {
    Bench bench;
    bench.first_steps(4);
    bench.command(command::Exclude{2});
    EXPECT_THAT(bench.used_deg(), ElementsAre(0, 10, 30, 40));
    const TurnData excluded = bench.state.data;
    bench.command(command::Undo{});
    EXPECT_THAT(bench.used_deg(), ElementsAre(0, 10, 20, 30, 40));
    bench.command(command::Undo{});
    EXPECT_THAT(bench.used_deg(), ElementsAre(0, 10, 20, 30));
    EXPECT_EQ(bench.state.data.captures.size(), 5U) << "given up, not deleted";
    bench.command(command::Redo{});
    bench.command(command::Redo{});
    EXPECT_EQ(bench.state.data, excluded);
    EXPECT_FALSE(bench.command(command::Redo{}));
    EXPECT_EQ(table_of(bench.state).size(), 3U) << "the pair around the hole was judged too";
}

TEST(Step, UndoneStepsAreTakenAgainUnderNewIndices) {
    Bench bench;
    bench.first_steps(2);
    bench.command(command::Undo{});
    ASSERT_TRUE(bench.command(command::Step{}));
    EXPECT_THAT(bench.used_deg(), ElementsAre(0, 10, 20));
    EXPECT_EQ(bench.state.data.last_used()->index, 3);
    EXPECT_EQ(bench.state.data.last_used()->attempt, 2);
}

TEST(Step, RetakeOfAnEarlierViewKeepsItsIndex) {
    Bench bench;
    bench.first_steps(4);
    bench.command(command::Retake{1});
    EXPECT_THAT(bench.used_deg(), ElementsAre(0, 10, 20, 30, 40));
    EXPECT_EQ(bench.state.data.find(1)->attempt, 2);
    EXPECT_EQ(table_of(bench.state).size(), 4U);
    bench.command(command::Step{});
    EXPECT_NEAR(bench.cell.joint6_rad, deg(-130.0), 1e-9);
    EXPECT_THAT(bench.used_deg(), ElementsAre(0, 10, 20, 30, 40, 50));
}

TEST(Step, LockingTheAxisJudgesTheLastStepAgain) {
    Bench bench;
    bench.work.judge = [](const CaptureRecord& from, const CaptureRecord& to) {
        TurnStep row = rejected_row(from.index, to.index, deg(10.0), Cause::kSymmetry);
        if (to.mode == TurnMode::kAxisLocked) {
            row.verdict = Verdict::kCheck;
            row.mode = TurnMode::kAxisLocked;
            row.independent = false;
        }
        return row;
    };
    bench.command(command::Connect{});
    bench.command(command::Run{});
    ASSERT_TRUE(bench.in<phase::Finished>());
    const auto table = table_of(bench.state);
    ASSERT_EQ(table.size(), 36U);
    for (const auto& step : table) {
        EXPECT_EQ(step.row.mode, TurnMode::kAxisLocked);
        EXPECT_FALSE(step.row.independent);
    }
}

TEST(Step, StopEndsTheMotionAndResumeGoesOnFromThere) {
    Bench bench;
    bench.first_steps(1);
    bench.give(command::Step{});
    Transition stopped = step(bench.state, Command{command::Stop{}});
    ASSERT_FALSE(stopped.refused);
    EXPECT_TRUE(std::holds_alternative<effect::Halt>(stopped.effects.front()));
    bench.give(command::Stop{});
    ASSERT_TRUE(bench.in<phase::Halting>());
    bench.waiting.clear();
    bench.give(event::TurnFailed{RobotFault::kStopped, 0, "stopped on request"});
    ASSERT_TRUE(bench.in<phase::Interrupted>());
    bench.command(command::Resume{});
    EXPECT_THAT(bench.used_deg(), ElementsAre(0, 10, 20));
}

TEST(Step, WhatEndsWellWhileStoppingIsKeptAndNothingNewBegins) {
    Bench bench;
    bench.first_steps(1);
    bench.give(command::Step{});
    bench.work_off(1);
    ASSERT_EQ(bench.waiting.size(), 1U);
    ASSERT_TRUE(std::holds_alternative<effect::Expose>(bench.waiting.front()));
    bench.give(command::Stop{});
    bench.work_off(1);
    EXPECT_THAT(bench.used_deg(), ElementsAre(0, 10, 20));
    EXPECT_TRUE(bench.in<phase::Interrupted>());
    EXPECT_THAT(bench.waiting, IsEmpty());
    bench.command(command::Resume{});
    EXPECT_EQ(table_of(bench.state).size(), 2U);
}

TEST(Step, PauseLetsTheStepEndAndStopsBeforeTheNext) {
    Bench bench;
    bench.first_steps(1);
    bench.give(command::Run{});
    bench.give(command::Pause{});
    bench.work_off();
    EXPECT_TRUE(bench.in<phase::Idle>());
    EXPECT_THAT(bench.used_deg(), ElementsAre(0, 10, 20));
}

TEST(Step, WithoutMotionRightsTheOperatorTurnsAndTellsTheAngle) {
    Bench bench(MotionMode::kManual);
    bench.command(command::Connect{});
    bench.command(command::CheckCell{});
    ASSERT_TRUE(bench.command(command::TellAngle{deg(30.0)}));
    ASSERT_TRUE(bench.command(command::Capture{}));
    ASSERT_TRUE(bench.command(command::Step{}));
    ASSERT_TRUE(bench.in<phase::Busy>());
    ASSERT_TRUE(bench.command(command::TellAngle{deg(41.5)}));
    EXPECT_THAT(bench.used_deg(), ElementsAre(0, 11.5)) << "what was told, not what was asked";
    EXPECT_THAT(bench.cell.motions_rad, IsEmpty());
    bench.command(command::Step{});
    EXPECT_TRUE(bench.command(command::Stop{}));
    EXPECT_TRUE(bench.in<phase::Idle>());
}

}  // namespace
}  // namespace gripscan
