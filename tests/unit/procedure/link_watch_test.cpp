#include "core/procedure/link_watch.h"

#include <gmock/gmock.h>

#include "tests/support/fake_work.h"

namespace gripscan {
namespace {

using namespace std::chrono_literals;
using testing::HasSubstr;

/// Beats when the test says so.
class BeatingLink : public RobotLink {
  public:
    RobotResult<RobotIdentity> connect() override { return RobotIdentity{}; }
    void disconnect() override {}
    RobotResult<ControllerState> state() override { return ControllerState{}; }
    RobotResult<RobotReading> read() override { return RobotReading{}; }
    RobotResult<RobotReading> turn_joint6(const Joint6Command&, std::stop_token) override {
        return RobotReading{};
    }
    RobotResult<void> stop() override { return {}; }
    void on_beat(std::function<void(const RobotBeat&)> receiver) override {
        receiver_ = std::move(receiver);
    }
    void beat(bool alive) const { receiver_({alive, {}, 0.001, alive ? "" : "no answer"}); }

  private:
    std::function<void(const RobotBeat&)> receiver_;
};

class LinkWatchOfAnEngine : public testing::Test {
  protected:
    void SetUp() override {
        ASSERT_TRUE(engine_.submit(command::Connect{}));
        while (std::holds_alternative<phase::Connecting>(engine_.state().phase)) {
            ASSERT_TRUE(engine_.pump(1s));
        }
    }
    /// What the engine makes of what it was told.
    const phase::Offline* offline() {
        while (engine_.pump(0ms).value_or(false)) {
        }
        return std::get_if<phase::Offline>(&engine_.state().phase);
    }

    test::FakeCell cell_;
    test::FakeWork work_{cell_};
    test::MemoryStore store_;
    test::MemoryJournal journal_;
    BeatingLink link_;  // outlives the engine, as the cell's does
    Engine engine_{ProcedureState{}, work_, store_, journal_};
};

TEST_F(LinkWatchOfAnEngine, ALostRobotIsNoticedWhileNothingIsAskedOfIt) {
    const LinkWatch watch(link_, engine_);
    link_.beat(true);
    link_.beat(false);
    EXPECT_EQ(offline(), nullptr) << "the next beat may open the connection again";
    link_.beat(true);
    link_.beat(false);
    EXPECT_EQ(offline(), nullptr) << "not two in a row";
    link_.beat(false);
    ASSERT_NE(offline(), nullptr);
    EXPECT_THAT(offline()->why, HasSubstr("no answer"));
    const std::size_t journalled = journal_.entries.size();
    for (int i = 0; i < 5; ++i) link_.beat(false);
    EXPECT_NE(offline(), nullptr);
    EXPECT_EQ(journal_.entries.size(), journalled) << "it is known";
}

TEST_F(LinkWatchOfAnEngine, TheLinkMayBeatOnWhenNobodyListensAnyMore) {
    { const LinkWatch watch(link_, engine_); }
    for (int i = 0; i < 5; ++i) link_.beat(false);
    EXPECT_EQ(offline(), nullptr);
}

}  // namespace
}  // namespace gripscan
