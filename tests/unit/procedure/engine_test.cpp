#include "core/procedure/engine.h"

#include <gmock/gmock.h>

#include "core/base/seeded_random.h"
#include "tests/support/fake_work.h"

namespace gripscan {
namespace {

using namespace std::chrono_literals;
using test::FakeCell;
using test::FakeWork;
using test::MemoryJournal;
using test::MemoryStore;
using testing::HasSubstr;

ProcedureState fresh() {
    ProcedureState state;
    state.plan.step_rad = state.data.step_rad = 20.0 * kRadPerDeg;
    return state;
}

bool resting(const ProcedureState& state) {
    return !std::holds_alternative<phase::Busy>(state.phase) &&
           !std::holds_alternative<phase::Connecting>(state.phase) &&
           !std::holds_alternative<phase::Halting>(state.phase);
}

Status pump_until_rest(Engine& engine) {
    while (!resting(engine.state())) {
        auto taken = engine.pump(1s);
        if (!taken) return forward_error(taken.error());
    }
    return {};
}

TEST(Engine, RunsAWholeTurnAndJournalsEveryInput) {
    FakeCell cell;
    FakeWork work(cell);
    MemoryStore store;
    MemoryJournal journal;
    ProcedureState after;
    {
        Engine engine(fresh(), work, store, journal);
        ASSERT_TRUE(engine.submit(command::Connect{}));
        ASSERT_TRUE(pump_until_rest(engine));
        ASSERT_TRUE(engine.submit(command::Run{}));
        ASSERT_TRUE(pump_until_rest(engine));
        after = engine.state();
    }
    ASSERT_TRUE(std::holds_alternative<phase::Finished>(after.phase));
    EXPECT_EQ(store.table, after.data.captures);
    const auto replayed = replay_inputs(fresh(), journal.inputs());
    ASSERT_TRUE(replayed) << replayed.error().message;
    EXPECT_EQ(replayed->data, after.data);
    EXPECT_EQ(replayed->next_motion_id, after.next_motion_id);
    EXPECT_TRUE(std::holds_alternative<phase::Finished>(replayed->phase));
}

TEST(Engine, ARefusedCommandIsAnsweredAndNotJournalled) {
    FakeCell cell;
    FakeWork work(cell);
    MemoryStore store;
    MemoryJournal journal;
    Engine engine(fresh(), work, store, journal);
    const auto reply = engine.submit(command::Step{});
    ASSERT_TRUE(reply);
    ASSERT_TRUE(reply->has_value());
    EXPECT_THAT(**reply, HasSubstr("not connected"));
    EXPECT_TRUE(journal.entries.empty());
}

TEST(Engine, WhatCannotBeJournalledDoesNotHappen) {
    FakeCell cell;
    FakeWork work(cell);
    MemoryStore store;
    MemoryJournal journal;
    journal.full_at = 9;
    Engine engine(fresh(), work, store, journal);
    ASSERT_TRUE(engine.submit(command::Connect{}));
    ASSERT_TRUE(pump_until_rest(engine));
    ASSERT_TRUE(engine.submit(command::Run{}));
    const Status broken = pump_until_rest(engine);
    ASSERT_FALSE(broken);
    EXPECT_THAT(broken.error().message, HasSubstr("no space"));
    EXPECT_FALSE(engine.submit(command::Stop{})) << "nothing more is taken";
    const auto replayed = replay_inputs(fresh(), journal.inputs());
    ASSERT_TRUE(replayed);
    EXPECT_EQ(replayed->data, engine.state().data);
}

TEST(Engine, ALinkLostAtRestIsTakenAndOneLostTwiceDoesNoHarm) {
    FakeCell cell;
    FakeWork work(cell);
    MemoryStore store;
    MemoryJournal journal;
    Engine engine(fresh(), work, store, journal);
    ASSERT_TRUE(engine.submit(command::Connect{}));
    ASSERT_TRUE(pump_until_rest(engine));
    engine.tell(event::LinkDown{"no heartbeat"});
    engine.tell(event::LinkDown{"no heartbeat"});
    while (!std::holds_alternative<phase::Offline>(engine.state().phase)) {
        ASSERT_TRUE(engine.pump(1s));
    }
    ASSERT_TRUE(engine.submit(command::Connect{}));
    ASSERT_TRUE(pump_until_rest(engine));
    EXPECT_TRUE(std::holds_alternative<phase::Idle>(engine.state().phase));
}

/// Killed after any number of journal entries: what is read back goes on to the same captures, and
/// no motion id is ever driven twice.
class KilledEngine : public testing::TestWithParam<bool> {};

TEST_P(KilledEngine, GoesOnToTheSameTurnFromEveryEntryOfTheJournal) {
    const bool cell_survives = GetParam();
    const auto judge = [](const CaptureRecord& from, const CaptureRecord& to) {
        const double turn_rad = to.commanded_rad - from.commanded_rad;
        // One view that is only good at its second attempt.
        if (from.index == 4 && to.attempt == 1) {
            return test::rejected_row(from.index, to.index, turn_rad, Cause::kExposure);
        }
        return test::accepted_row(from.index, to.index, turn_rad);
    };
    std::vector<CaptureRecord> undisturbed;
    for (std::size_t killed_at = 1000; killed_at > 0;
         killed_at = killed_at > 999 ? 110 : killed_at - 1) {
        FakeCell cell;
        MemoryJournal journal;
        MemoryStore store;
        journal.full_at = killed_at;
        {
            FakeWork work(cell);
            work.judge = judge;
            Engine engine(fresh(), work, store, journal);
            (void)engine.submit(command::Connect{});
            (void)pump_until_rest(engine);
            (void)engine.submit(command::Run{});
            (void)pump_until_rest(engine);
        }
        journal.full_at.reset();
        if (killed_at == 1000) {
            undisturbed = store.table;
            ASSERT_EQ(undisturbed.size(), 20U) << "19 views and one retake";
            continue;
        }
        if (!cell_survives) cell = FakeCell{};
        auto memory = replay_inputs(fresh(), journal.inputs());
        ASSERT_TRUE(memory) << memory.error().message;
        FakeWork work(cell);
        work.judge = judge;
        MemoryStore store_again;
        Engine engine(*memory, work, store_again, journal);
        engine.tell(event::ProgramEnded{});
        ASSERT_TRUE(engine.pump(1s));
        ASSERT_TRUE(engine.submit(command::Connect{}));
        ASSERT_TRUE(pump_until_rest(engine));
        if (std::holds_alternative<phase::Interrupted>(engine.state().phase)) {
            ASSERT_TRUE(engine.submit(command::Resume{}));
        }
        if (!std::holds_alternative<phase::Finished>(engine.state().phase)) {
            ASSERT_TRUE(engine.submit(command::Run{}));
            ASSERT_TRUE(pump_until_rest(engine));
        }
        ASSERT_TRUE(std::holds_alternative<phase::Finished>(engine.state().phase)) << killed_at;
        ASSERT_EQ(engine.state().data.captures, undisturbed) << "killed at entry " << killed_at;
    }
}

INSTANTIATE_TEST_SUITE_P(CellSurvivesOrNot, KilledEngine, testing::Bool());

}  // namespace
}  // namespace gripscan
