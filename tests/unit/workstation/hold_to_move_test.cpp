// LIVE: no motion by hand without the button, none goes on after it was let go.
#include "app/workstation/hold_to_move.h"

#include <gtest/gtest.h>

#include "core/procedure/step.h"
#include "tests/support/sample_snapshot.h"

namespace gripscan::app {
namespace {

using test::Sample;

ProcedureState state_of(Sample sample, MotionMode mode) {
    test::set_mode(sample, mode);
    return *sample.state;
}

/// After a step was begun.
ProcedureState stepping(MotionMode mode) {
    const Transition begun = step(state_of(test::sample_running(), mode), Command(command::Step{}));
    EXPECT_FALSE(begun.refused) << *begun.refused;
    return begun.state;
}

TEST(HoldToMove, AMotionByHandWaitsForTheButton) {
    const ProcedureState live = state_of(test::sample_running(), MotionMode::kLive);
    EXPECT_TRUE(why_not_held(live, command::Step{}, false));
    EXPECT_FALSE(why_not_held(live, command::Step{}, true));
    EXPECT_TRUE(why_not_held(live, command::Back{}, false)) << "the way back moves the arm, too";
    EXPECT_FALSE(why_not_held(live, command::Undo{}, false)) << "it changes the captures only";
    EXPECT_FALSE(why_not_held(live, command::Stop{}, false));
    EXPECT_FALSE(why_not_held(live, command::Run{}, false)) << "begun in words";
    for (const MotionMode other : {MotionMode::kSim, MotionMode::kDry}) {
        const ProcedureState state = state_of(test::sample_running(), other);
        EXPECT_FALSE(why_not_held(state, command::Step{}, false));
        EXPECT_FALSE(begun_by_holding(state));
    }
}

TEST(HoldToMove, HoldingBeginsWhatIsNextIfItMoves) {
    const auto begun = begun_by_holding(state_of(test::sample_running(), MotionMode::kLive));
    ASSERT_TRUE(begun);
    EXPECT_TRUE(std::holds_alternative<command::Step>(*begun));
    EXPECT_FALSE(begun_by_holding(state_of(test::sample_empty(), MotionMode::kLive)))
        << "to connect is no motion";
    EXPECT_FALSE(begun_by_holding(stepping(MotionMode::kLive))) << "it moves already";
}

TEST(HoldToMove, LettingGoStopsWhatWasBegunByHand) {
    const auto asked = asked_by_letting_go(stepping(MotionMode::kLive));
    ASSERT_TRUE(asked);
    EXPECT_TRUE(std::holds_alternative<command::Stop>(*asked));
    EXPECT_FALSE(asked_by_letting_go(stepping(MotionMode::kSim)));
    EXPECT_FALSE(asked_by_letting_go(state_of(test::sample_running(), MotionMode::kLive)));
    ProcedureState runs = stepping(MotionMode::kLive);
    runs.running = true;
    EXPECT_FALSE(asked_by_letting_go(runs));
}

}  // namespace
}  // namespace gripscan::app
