// step() and a fake cell, driven by hand and without threads.
#pragma once

#include <gtest/gtest.h>

#include <cmath>

#include "core/procedure/step.h"
#include "tests/support/fake_work.h"

namespace gripscan::test {

inline double deg(double angle) {
    return angle * kRadPerDeg;
}

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

}  // namespace gripscan::test
