// Where the procedure lets joint 6 go, by which way, and under which ids.
#include <gmock/gmock.h>

#include <algorithm>
#include <limits>

#include "tests/unit/procedure/step_bench.h"

namespace gripscan {
namespace {

using test::Bench;
using test::deg;
using test::FakeCell;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

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

}  // namespace
}  // namespace gripscan
