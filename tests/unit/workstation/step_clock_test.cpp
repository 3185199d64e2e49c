#include "app/workstation/step_clock.h"

#include <gtest/gtest.h>

namespace gripscan::app {
namespace {

/// A turn of 10° steps with so many of them judged.
ProcedureState turn_of(int steps) {
    ProcedureState state;
    state.data.step_rad = state.plan.step_rad;
    for (int i = 0; i <= steps; ++i) {
        CaptureRecord capture;
        capture.index = i;
        capture.commanded_rad = i * state.plan.step_rad;
        state.data.captures.push_back(capture);
        if (i > 0) state.judged[{i - 1, i}] = {};
    }
    return state;
}

TEST(StepClock, TellsTheRestFromTheTimesOfTheSteps) {
    StepClock clock;
    EXPECT_FALSE(clock.seconds_left(turn_of(0)));
    for (int step = 0; step <= 6; ++step) clock.tell(turn_of(step), 100.0 + 2.0 * step);
    const auto left_s = clock.seconds_left(turn_of(6));
    ASSERT_TRUE(left_s);
    EXPECT_NEAR(*left_s, 30 * 2.0, 1e-9);
    EXPECT_FALSE(clock.seconds_left(turn_of(36)));
}

TEST(StepClock, APauseOfTheOperatorIsNoStep) {
    StepClock clock;
    for (int step = 0; step <= 3; ++step) clock.tell(turn_of(step), 2.0 * step);
    clock.tell(turn_of(4), 3600.0);
    EXPECT_NEAR(clock.seconds_left(turn_of(4)).value_or(0.0), 32 * 2.0, 1e-9);
}

TEST(StepClock, TimesWhatGoesOn) {
    StepClock clock;
    ProcedureState state = turn_of(0);
    clock.tell(state, 1.0);
    EXPECT_FALSE(clock.busy_since_s());
    state.phase = phase::Busy{activity::Exposing{}};
    clock.tell(state, 2.0);
    clock.tell(state, 3.0);
    EXPECT_EQ(clock.busy_since_s(), 2.0);
    state.phase = phase::Busy{activity::Judging{}};
    clock.tell(state, 4.0);
    EXPECT_EQ(clock.busy_since_s(), 4.0);
    state.phase = phase::Idle{};
    clock.tell(state, 5.0);
    EXPECT_FALSE(clock.busy_since_s());
}

}  // namespace
}  // namespace gripscan::app
