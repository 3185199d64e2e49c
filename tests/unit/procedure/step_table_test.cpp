// Every command and event in every phase, and what a plan may become.
#include <gmock/gmock.h>

#include "tests/unit/procedure/step_bench.h"

namespace gripscan {
namespace {

using test::Bench;
using test::deg;
using test::rejected_row;
using testing::IsEmpty;

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
