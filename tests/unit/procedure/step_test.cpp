#include "core/procedure/step.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <limits>

#include "tests/support/fake_work.h"

namespace gripscan {
namespace {

using test::accepted_row;
using test::FakeCell;
using test::FakeWork;
using test::rejected_row;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

double deg(double angle) {
    return angle * kRadPerDeg;
}

/// Drives step() and a fake cell by hand, without threads.
struct Bench {
    FakeCell cell;
    FakeWork work{cell};
    ProcedureState state;
    std::vector<Effect> waiting;  ///< asked for, not done yet
    std::string refused;

    explicit Bench(MotionMode mode = MotionMode::kSim, double step_deg = 10.0) {
        state.plan.mode = mode;
        state.plan.step_rad = deg(step_deg);
        state.data.step_rad = state.plan.step_rad;
    }
    bool give(const Input& input) {
        Transition t = step(state, input);
        refused = t.refused.value_or("");
        if (t.refused) return false;
        state = std::move(t.state);
        for (const Effect& effect : t.effects) {
            if (!std::holds_alternative<effect::SaveTable>(effect) &&
                !std::holds_alternative<effect::Halt>(effect)) {
                waiting.push_back(effect);
            }
        }
        EXPECT_LE(waiting.size(), 1U) << "one thing at a time";
        return true;
    }
    /// Does what is asked for until nothing is, at most `most` effects.
    void work_off(int most = 100000) {
        while (!waiting.empty() && most-- > 0) {
            const Effect effect = waiting.front();
            waiting.clear();
            const Event event = work.run(effect, state, {});
            EXPECT_TRUE(give(event)) << word(event) << ": " << refused;
        }
    }
    bool command(const Command& c) {
        if (!give(c)) return false;
        work_off();
        return true;
    }
    template <typename T>
    bool in() const {
        return std::holds_alternative<T>(state.phase);
    }
    std::vector<double> used_deg() const {
        std::vector<double> angles;
        for (const std::size_t i : state.data.used()) {
            angles.push_back(std::round(state.data.captures[i].commanded_rad * kDegPerRad * 100) /
                             100);
        }
        return angles;
    }
    void ready() {
        command(command::Connect{});
        command(command::CheckCell{});
        command(command::WarmUp{});
    }
    void first_steps(int steps) {
        ready();
        command(command::Capture{});
        for (int i = 0; i < steps; ++i) command(command::Step{});
    }
    AdvisedAction advised() const { return std::get<phase::Deciding>(state.phase).advice.action; }
};

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

TEST(Step, EveryViewIsApproachedUpwards) {
    Bench bench;
    bench.first_steps(3);
    bench.command(command::Back{});
    double before = deg(-180.0);
    std::vector<double> arrivals;
    for (const double angle : bench.cell.motions_rad) {
        EXPECT_LE(std::abs(angle - before), bench.state.plan.largest_move_rad + 1e-9);
        if (std::abs(std::remainder(angle * kDegPerRad, 1.0)) < 1e-9) arrivals.push_back(angle);
        before = angle;
    }
    EXPECT_GT(bench.cell.motions_rad.back(),
              bench.cell.motions_rad[bench.cell.motions_rad.size() - 2])
        << "back by more than the step, then up";
    EXPECT_NEAR(bench.cell.joint6_rad, deg(-160.0), 1e-12);
    EXPECT_THAT(bench.used_deg(), ElementsAre(0, 10, 20));
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

TEST(Step, AStaleIdIsReplacedByOneAboveTheControllers) {
    Bench bench;
    bench.cell.last_id = 57;
    bench.first_steps(1);
    EXPECT_GT(bench.cell.last_id, 57);
    EXPECT_THAT(bench.used_deg(), ElementsAre(0, 10));
}

TEST(Step, ALostLinkKeepsTheIdAndAsksAgain) {
    Bench bench;
    bench.first_steps(1);
    bench.give(command::Step{});
    const auto sent = std::get<effect::Turn>(bench.waiting.front()).command;
    bench.waiting.clear();
    ASSERT_TRUE(bench.give(event::TurnFailed{RobotFault::kLost, 0, "the link went"}));
    ASSERT_TRUE(bench.in<phase::Offline>());
    EXPECT_FALSE(bench.command(command::Resume{})) << "connect first";
    bench.command(command::Connect{});
    ASSERT_TRUE(bench.in<phase::Interrupted>());
    bench.give(command::Resume{});
    const auto again = std::get<effect::Turn>(bench.waiting.front()).command;
    EXPECT_EQ(again.id, sent.id);
    EXPECT_EQ(again.angle_rad, sent.angle_rad);
    bench.work_off();
    EXPECT_THAT(bench.used_deg(), ElementsAre(0, 10, 20));
}

TEST(Step, AMotionThatEndedBadlyIsPlannedAnewUnderANewId) {
    Bench bench;
    bench.first_steps(1);
    bench.give(command::Step{});
    const auto sent = std::get<effect::Turn>(bench.waiting.front()).command;
    bench.waiting.clear();
    ASSERT_TRUE(bench.give(event::TurnFailed{RobotFault::kRefused, 0, "emergency stop"}));
    ASSERT_TRUE(bench.in<phase::Interrupted>());
    bench.give(command::Resume{});
    EXPECT_GT(std::get<effect::Turn>(bench.waiting.front()).command.id, sent.id);
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

TEST(Step, DryRunWritesTheMotionsDownAndMovesNothing) {
    Bench bench(MotionMode::kDry);
    bench.state.plan.largest_move_rad = deg(40.0);
    bench.cell.joint6_rad = deg(10.0);  // the turn does not fit from there
    int logged = 0;
    bench.work.interfere = [&](const Effect& effect) -> std::optional<Event> {
        if (std::holds_alternative<effect::LogTurn>(effect)) ++logged;
        EXPECT_FALSE(std::holds_alternative<effect::Turn>(effect));
        EXPECT_FALSE(std::holds_alternative<effect::Expose>(effect));
        return std::nullopt;
    };
    bench.command(command::Connect{});
    bench.command(command::Run{});
    EXPECT_TRUE(bench.in<phase::Finished>());
    EXPECT_EQ(logged, 36);
    EXPECT_FALSE(bench.command(command::Retry{}));
    EXPECT_THAT(bench.refused, HasSubstr("DRY"));
    EXPECT_THAT(bench.cell.motions_rad, IsEmpty());

    // What LIVE would send: to the start, the steps, and home, in pieces and arriving upwards.
    Bench live;
    live.state.plan.largest_move_rad = deg(40.0);
    live.cell.joint6_rad = deg(10.0);
    live.command(command::Connect{});
    live.command(command::Run{});
    ASSERT_TRUE(live.in<phase::Finished>());
    // But for the warm-up, two small turns from where the joint stands.
    ASSERT_NEAR(live.cell.motions_rad[0], deg(14.0), 1e-9);
    ASSERT_NEAR(live.cell.motions_rad[1], deg(18.0), 1e-9);
    const std::vector<double> sent(live.cell.motions_rad.begin() + 2, live.cell.motions_rad.end());
    const auto arrived_at = [&](const std::vector<double>& motions, double angle_rad) {
        return std::ranges::find_if(motions,
                                    [&](double m) { return std::abs(m - angle_rad) < deg(0.001); });
    };
    const std::vector<double> logged_rad = bench.state.rehearsed_joint6_rad;
    // From there the way to the start is 8 deg longer in LIVE; the rest is the same.
    const std::vector<double> rest_logged(arrived_at(logged_rad, deg(-180.0)), logged_rad.end());
    const std::vector<double> rest_sent(arrived_at(sent, deg(-180.0)), sent.end());
    ASSERT_EQ(rest_logged.size(), rest_sent.size());
    for (std::size_t i = 0; i < rest_sent.size(); ++i) {
        EXPECT_NEAR(rest_logged[i], rest_sent[i], 1e-9) << i;
    }
    double at_rad = deg(10.0);
    for (const double to_rad : logged_rad) {
        EXPECT_LE(std::abs(to_rad - at_rad), deg(40.0) + 1e-9);
        at_rad = to_rad;
    }
    EXPECT_NEAR(at_rad, deg(-180.0), 1e-9);
}

TEST(Step, TheWarmUpTurnsWhereTheJointStands) {
    Bench bench;
    bench.cell.joint6_rad = deg(50.0);  // the turn begins at -180
    bench.ready();
    ASSERT_EQ(bench.cell.motions_rad.size(), 2U);
    EXPECT_NEAR(bench.cell.motions_rad[0], deg(54.0), 1e-9);
    EXPECT_NEAR(bench.cell.motions_rad[1], deg(58.0), 1e-9);
    // A check that fails by what the warm-up has shown keeps the arm from the long way.
    ASSERT_EQ(bench.cell.shots.size(), 3U);
    bench.command(command::Capture{});
    EXPECT_NEAR(bench.cell.joint6_rad, deg(-180.0), 1e-9);
    EXPECT_THAT(bench.used_deg(), ElementsAre(0));
}

TEST(Step, AtTheEndOfItsRangeTheWarmUpGoesBackFirst) {
    Bench bench;
    bench.cell.joint6_rad = deg(359.0);
    bench.ready();
    EXPECT_NEAR(bench.cell.joint6_rad, deg(360.0), 1e-9);
    EXPECT_EQ(bench.cell.shots.size(), 3U);
}

TEST(Step, AWarmUpThatWasCutOffIsBegunAgainAtTheSameAngles) {
    Bench undisturbed;
    undisturbed.cell.joint6_rad = deg(50.0);
    undisturbed.ready();
    Bench bench;
    bench.cell.joint6_rad = deg(50.0);
    bench.command(command::Connect{});
    bench.command(command::CheckCell{});
    bench.give(command::WarmUp{});
    bench.work_off(3);  // a picture, a turn, a picture
    ASSERT_EQ(bench.cell.shots.size(), 2U);
    bench.waiting.clear();
    bench.give(event::ProgramEnded{});
    bench.cell.shots.clear();
    bench.command(command::Connect{});
    if (bench.in<phase::Interrupted>()) bench.command(command::Resume{});
    bench.command(command::WarmUp{});
    ASSERT_EQ(bench.cell.shots.size(), 3U);
    for (std::size_t i = 0; i < 3; ++i) {
        EXPECT_NEAR(bench.cell.shots[i].commanded_rad, undisturbed.cell.shots[i].commanded_rad,
                    1e-9);
    }
    EXPECT_NEAR(bench.cell.joint6_rad, undisturbed.cell.joint6_rad, 1e-9);
}

TEST(Step, TheFirstViewIsApproachedUpwardsToo) {
    Bench bench;
    bench.command(command::Connect{});
    bench.command(command::CheckCell{});
    bench.command(command::Capture{});  // without a warm-up, the joint stands at the start
    EXPECT_THAT(bench.cell.motions_rad, ElementsAre(deg(-183.0), deg(-180.0)));
    EXPECT_THAT(bench.used_deg(), ElementsAre(0));
}

/// The program was killed in the middle of something, and the cell with it: it stands at its home.
TEST(Step, AKilledRunArrivesAtEveryAngleAsAnUndisturbedOneDoes) {
    Bench bench;
    bench.state.plan.largest_move_rad = deg(40.0);
    bench.first_steps(20);
    bench.give(command::Step{});
    ASSERT_TRUE(std::holds_alternative<effect::Turn>(bench.waiting.front()));
    const auto kill = [&] {
        bench.waiting.clear();
        bench.give(event::ProgramEnded{});
        bench.cell = FakeCell{};
        bench.command(command::Connect{});
    };
    kill();
    // The motion that was under way begins far from there now: in pieces, under new ids.
    ASSERT_TRUE(bench.give(command::Resume{}));
    const auto* turn = std::get_if<effect::Turn>(&bench.waiting.front());
    ASSERT_NE(turn, nullptr);
    EXPECT_LE(turn->command.angle_rad, deg(-180.0 + 40.0) + 1e-9);
    bench.work_off();
    EXPECT_EQ(bench.state.data.used().size(), 22U);
    EXPECT_NEAR(bench.cell.joint6_rad, deg(-180.0 + 210.0), 1e-9);

    // Killed while the first view is exposed, at home: it stands there, but has not come from
    // below.
    Bench first;
    first.ready();
    first.give(command::Capture{});
    while (!std::holds_alternative<effect::Expose>(first.waiting.front())) first.work_off(1);
    first.waiting.clear();
    first.give(event::ProgramEnded{});
    first.cell = FakeCell{};
    first.command(command::Connect{});
    first.command(command::Resume{});
    EXPECT_THAT(first.cell.motions_rad, ElementsAre(deg(-183.0), deg(-180.0)));
    EXPECT_THAT(first.used_deg(), ElementsAre(0));
}

TEST(Step, AJournalWithoutThatChoiceWarmsUpAtTheStartOfTheTurn) {
    Bench bench;
    bench.state.plan.warm_up_in_place.reset();
    bench.cell.joint6_rad = deg(50.0);
    bench.ready();
    EXPECT_NEAR(bench.cell.joint6_rad, deg(-180.0 + 8.0), 1e-9);
}

TEST(Step, IdsBehindTheControllersAreRaisedOnceAndThenItIsAsked) {
    Bench bench;
    bench.cell.last_id = 40;  // of an earlier session
    bench.first_steps(1);
    EXPECT_THAT(bench.used_deg(), ElementsAre(0, 10));
    EXPECT_GT(bench.state.next_motion_id, 40);

    // A controller that calls every id stale.
    int asked = 0;
    bench.work.interfere = [&](const Effect& effect) -> std::optional<Event> {
        const auto* turn = std::get_if<effect::Turn>(&effect);
        if (turn == nullptr) return std::nullopt;
        ++asked;
        return event::TurnFailed{RobotFault::kStaleId, turn->command.id, "motion is behind"};
    };
    bench.command(command::Step{});
    EXPECT_EQ(asked, 2);
    ASSERT_TRUE(bench.in<phase::Interrupted>());
    EXPECT_THAT(std::get<phase::Interrupted>(bench.state.phase).why,
                HasSubstr("restart the server"));
    bench.work.interfere = nullptr;
    bench.command(command::Resume{});
    EXPECT_THAT(bench.used_deg(), ElementsAre(0, 10, 20));
}

TEST(Step, TheLargestIdThereIsIsNotPassed) {
    Bench bench;
    bench.first_steps(1);
    bench.work.interfere = [&](const Effect& effect) -> std::optional<Event> {
        if (!std::holds_alternative<effect::Turn>(effect)) return std::nullopt;
        return event::TurnFailed{RobotFault::kStaleId, std::numeric_limits<int>::max(), "behind"};
    };
    bench.command(command::Step{});
    EXPECT_TRUE(bench.in<phase::Interrupted>());
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

TEST(Step, TheTurnStartsWhereItFitsIntoTheJointsRange) {
    Bench from_zero;
    from_zero.cell.joint6_rad = 0.0;
    from_zero.first_steps(0);
    EXPECT_NEAR(*from_zero.state.plan.start_joint6_rad, 0.0, 1e-12);
    Bench from_ninety;
    from_ninety.cell.joint6_rad = deg(90.0);
    from_ninety.first_steps(0);
    EXPECT_NEAR(*from_ninety.state.plan.start_joint6_rad, deg(-180.0), 1e-12);
    EXPECT_NEAR(from_ninety.cell.joint6_rad, deg(-180.0), 1e-12);
}

/// One state for every phase, and with every activity.
std::vector<std::pair<std::string, ProcedureState>> every_phase() {
    std::vector<std::pair<std::string, ProcedureState>> states;
    Bench bench;
    states.emplace_back("offline", bench.state);
    bench.give(command::Connect{});
    states.emplace_back("connecting", bench.state);
    bench.work_off();
    states.emplace_back("idle, unchecked", bench.state);
    bench.give(command::CheckCell{});
    states.emplace_back("checking", bench.state);
    bench.work_off();
    bench.give(command::WarmUp{});
    states.emplace_back("warming up", bench.state);
    bench.work_off();
    states.emplace_back("idle, warm", bench.state);
    bench.command(command::Capture{});
    states.emplace_back("idle, one view", bench.state);
    bench.give(command::Step{});
    states.emplace_back("moving", bench.state);
    bench.work_off(1);
    states.emplace_back("exposing", bench.state);
    bench.work_off(1);
    states.emplace_back("judging", bench.state);
    bench.work_off();
    bench.command(command::Step{});
    states.emplace_back("idle, steps", bench.state);
    bench.give(command::Finish{});
    states.emplace_back("solving", bench.state);
    bench.give(command::Stop{});
    states.emplace_back("halting", bench.state);
    bench.waiting.clear();
    bench.give(event::WorkFailed{"cancelled"});
    states.emplace_back("interrupted", bench.state);
    bench.command(command::Resume{});
    states.emplace_back("finished", bench.state);
    Bench rejecting;
    rejecting.work.judge = [](const CaptureRecord& from, const CaptureRecord& to) {
        return rejected_row(from.index, to.index, deg(10.0), Cause::kOverlap);
    };
    rejecting.first_steps(1);
    states.emplace_back("deciding", rejecting.state);
    return states;
}

std::vector<Command> every_command() {
    return {command::Connect{},      command::CheckCell{}, command::WarmUp{},
            command::Capture{},      command::Step{},      command::Retry{},
            command::Halve{},        command::LockAxis{},  command::Accept{"seen"},
            command::Back{},         command::Undo{},      command::Redo{},
            command::Exclude{1},     command::Retake{1},   command::TellAngle{0.1},
            command::Run{},          command::Pause{},     command::Stop{},
            command::Resume{},       command::Finish{},    command::SetPlan{},
            command::Accept{" \t\n"}};
}

/// What was measured for the plan before does not hold for the new one; the recording is judged by
/// the new one, and mad ones are refused by name.
TEST(Step, ThePlanChangesBeforeTheFirstViewAndThenNoMore) {
    Bench bench;
    bench.command(command::Connect{});
    bench.command(command::CheckCell{});
    TurnPlan plan = bench.state.plan;
    plan.step_rad = deg(20.0);
    plan.limits.angle_rad = deg(0.25);
    const Transition changed = step(bench.state, Command(command::SetPlan{plan}));
    ASSERT_FALSE(changed.refused) << *changed.refused;
    EXPECT_DOUBLE_EQ(changed.state.data.step_rad, deg(20.0));
    EXPECT_FALSE(changed.state.cell);
    ASSERT_EQ(changed.effects.size(), 1U);
    EXPECT_TRUE(std::holds_alternative<effect::SavePlan>(changed.effects[0]));

    std::vector<TurnPlan> mad(5, plan);
    mad[0].step_rad = deg(0.1);
    mad[1].step_rad = std::nan("");
    mad[2].speed_percent = 0.0;
    mad[3].limits.overlap = 1.5;
    mad[4].mode = MotionMode::kLive;
    for (const TurnPlan& wrong : mad) {
        EXPECT_TRUE(refusal(bench.state, command::SetPlan{wrong}));
    }
    bench.first_steps(1);
    EXPECT_TRUE(refusal(bench.state, command::SetPlan{plan}));
}

/// The speed is no part of what a view is judged by.
TEST(Step, TheSpeedMayChangeBetweenTheStepsAndNothingElseIsLostByIt) {
    Bench bench;
    bench.first_steps(2);
    TurnPlan faster = bench.state.plan;
    faster.speed_percent = 25.0;
    const Transition changed = step(bench.state, Command(command::SetPlan{faster}));
    ASSERT_FALSE(changed.refused) << *changed.refused;
    EXPECT_DOUBLE_EQ(changed.state.plan.speed_percent, 25.0);
    EXPECT_EQ(changed.state.undo.size(), bench.state.undo.size());
    EXPECT_EQ(changed.state.cell.has_value(), bench.state.cell.has_value());
    ASSERT_EQ(changed.effects.size(), 1U);
    EXPECT_TRUE(std::holds_alternative<effect::SavePlan>(changed.effects[0]));
    faster.limits.sigmas += 1.0;
    EXPECT_TRUE(refusal(bench.state, command::SetPlan{faster}));
    faster.limits.sigmas -= 1.0;
    faster.speed_percent = 101.0;
    EXPECT_TRUE(refusal(bench.state, command::SetPlan{faster}));
}

/// Which commands are taken in which phase; everything else is refused with a reason. Accepting
/// with a blank note never is.
TEST(Step, TableOfCommandsAndPhases) {
    const std::map<std::string, std::vector<std::string>> taken{
        {"offline", {"connect", "set_plan"}},
        {"connecting", {}},
        {"idle, unchecked", {"check_cell", "lock_axis", "run", "set_plan"}},
        {"checking", {"run", "stop"}},
        {"warming up", {"run", "stop"}},
        {"idle, warm", {"check_cell", "warm_up", "capture", "lock_axis", "run", "set_plan"}},
        {"idle, one view", {"step", "retry", "lock_axis", "undo", "run"}},
        {"moving", {"run", "stop"}},
        {"exposing", {"run", "stop"}},
        {"judging", {"run", "stop"}},
        {"idle, steps",
         {"step", "retry", "halve", "lock_axis", "back", "undo", "exclude", "retake", "run",
          "finish"}},
        {"solving", {"run", "stop"}},
        {"halting", {}},
        {"interrupted", {"connect", "resume"}},
        {"finished",
         {"retry", "halve", "lock_axis", "back", "undo", "exclude", "retake", "finish"}},
        {"deciding",
         {"step", "retry", "halve", "lock_axis", "accept", "back", "undo", "exclude", "retake",
          "run", "finish"}},
    };
    for (const auto& [name, state] : every_phase()) {
        ASSERT_TRUE(taken.contains(name)) << name;
        std::vector<std::string> found;
        for (const Command& command : every_command()) {
            const Transition t = step(state, command);
            EXPECT_EQ(t.refused.has_value(), refusal(state, command).has_value())
                << name << ", " << word(command);
            if (t.refused) {
                EXPECT_FALSE(t.refused->empty());
                EXPECT_THAT(t.effects, IsEmpty()) << name << ", " << word(command);
            } else {
                found.emplace_back(word(command));
            }
        }
        EXPECT_EQ(found, taken.at(name)) << name;
    }
}

std::vector<Event> every_event() {
    return {event::LinkUp{},      event::LinkDown{"gone"}, event::CellChecked{},
            event::Arrived{},     event::TurnFailed{},     event::TurnLogged{},
            event::Exposed{},     event::ExposureFailed{}, event::Judged{},
            event::AxisFound{},   event::Solved{},         event::WorkFailed{"failed"},
            event::ProgramEnded{}};
}

/// Which events are expected in which phase; the others are refused and change nothing.
TEST(Step, TableOfEventsAndPhases) {
    const std::map<std::string, std::vector<std::string>> taken{
        {"offline", {"program_ended"}},
        {"connecting", {"link_up", "link_down", "program_ended"}},
        {"idle, unchecked", {"link_down", "program_ended"}},
        {"checking", {"cell_checked", "work_failed", "program_ended"}},
        {"warming up", {"exposed", "exposure_failed", "program_ended"}},
        {"idle, warm", {"link_down", "program_ended"}},
        {"idle, one view", {"link_down", "program_ended"}},
        {"moving", {"arrived", "turn_failed", "turn_logged", "program_ended"}},
        {"exposing", {"exposed", "exposure_failed", "program_ended"}},
        {"judging", {"judged", "work_failed", "program_ended"}},
        {"idle, steps", {"link_down", "program_ended"}},
        {"solving", {"solved", "work_failed", "program_ended"}},
        {"halting", {"solved", "work_failed", "program_ended"}},
        {"interrupted", {"link_down", "program_ended"}},
        {"finished", {"link_down", "program_ended"}},
        {"deciding", {"link_down", "program_ended"}},
    };
    for (const auto& [name, state] : every_phase()) {
        ASSERT_TRUE(taken.contains(name)) << name;
        std::vector<std::string> found;
        for (const Event& event : every_event()) {
            const Transition t = step(state, event);
            if (!t.refused) found.emplace_back(word(event));
        }
        EXPECT_EQ(found, taken.at(name)) << name;
    }
}

}  // namespace
}  // namespace gripscan
