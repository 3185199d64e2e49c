#include "core/robot/gsp_exchange.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/robot/command_ids.h"

namespace gripscan::gsp {
namespace {

using testing::HasSubstr;

constexpr int kId = 17;
const TurnRules kRules{{kId, 30.0, 10.0}, 2};

RobotError trouble(RobotFault fault) {
    return {fault, 0, 0, "the cable is out"};
}

// Names of the states and of what happens, for the table.
const std::map<std::string, TurnState>& states() {
    static const std::map<std::string, TurnState> all{
        {"idle", TurnIdle{}},
        {"sent", TurnSent{0}},
        {"sent again", TurnSent{1}},
        {"sent last", TurnSent{2}},
        {"accepted", TurnAccepted{0}},
        {"accepted last", TurnAccepted{2}},
        {"lost", TurnLost{0, trouble(RobotFault::kLost)}},
        {"late", TurnLost{0, trouble(RobotFault::kTimeout)}},
        {"done", TurnDone{}},
        {"failed", TurnFailed{trouble(RobotFault::kRefused)}},
    };
    return all;
}

const std::map<std::string, TurnInput>& inputs() {
    static const std::map<std::string, TurnInput> all{
        {"begin", Begin{}},
        {"ACC", Reply(Accepted{kId})},
        {"ACC other", Reply(Accepted{kId - 1})},
        {"DONE", Reply(Done{kId, {}})},
        {"DONE other", Reply(Done{kId - 1, {}})},
        {"ERR 200", Reply(Failure{kId, ErrorCode::kNotAutomatic, ""})},
        {"ERR 304", Reply(Failure{kId, ErrorCode::kStaleId, "last=40 passed"})},
        {"ERR 410", Reply(Failure{kId, ErrorCode::kStopped, ""})},
        {"ERR other", Reply(Failure{kId - 1, ErrorCode::kOffTarget, ""})},
        {"ERR 0", Reply(Failure{0, ErrorCode::kMalformed, ""})},
        {"HELLO", Reply(HelloReply{})},
        {"STATE", Reply(StateReply{})},
        {"POS", Reply(PositionReply{})},
        {"STOP", Reply(StopReply{})},
        {"garbled", LinkTrouble{trouble(RobotFault::kProtocol)}},
        {"link gone", LinkTrouble{trouble(RobotFault::kLost)}},
        {"time up", TimeUp{trouble(RobotFault::kTimeout)}},
        {"link back", LinkBack{}},
        {"stands still", StandsStill{}},
        {"gave up", GaveUp{}},
    };
    return all;
}

std::string name_of(const TurnState& state) {
    static constexpr std::array kNames{"idle", "sent", "accepted", "lost", "done", "failed"};
    std::string name = kNames.at(state.index());
    if (const auto* sent = std::get_if<TurnSent>(&state)) name += std::to_string(sent->recoveries);
    if (const auto* failed = std::get_if<TurnFailed>(&state)) {
        static const std::map<RobotFault, std::string> kFaults{
            {RobotFault::kLost, " lost"},           {RobotFault::kTimeout, " timeout"},
            {RobotFault::kRefused, " refused"},     {RobotFault::kStaleId, " stale"},
            {RobotFault::kStopped, " stopped"},     {RobotFault::kProtocol, " protocol"},
            {RobotFault::kOffTarget, " off target"}};
        name += kFaults.at(failed->error.fault);
    }
    return name;
}

/// What each state makes of each input; a pair that is not here is unexpected.
const std::map<std::pair<std::string, std::string>, std::pair<std::string, TurnAction>>& table() {
    using enum TurnAction;
    static const std::map<std::pair<std::string, std::string>, std::pair<std::string, TurnAction>>
        all{
            {{"idle", "begin"}, {"sent0", kSend}},

            {{"sent", "ACC"}, {"accepted", kWait}},
            {{"sent", "DONE"}, {"done", kFinish}},
            {{"sent", "ERR 200"}, {"failed refused", kFinish}},
            {{"sent", "ERR 304"}, {"failed stale", kFinish}},
            {{"sent", "ERR 410"}, {"failed stopped", kFinish}},
            {{"sent", "ERR 0"}, {"failed protocol", kFinish}},
            {{"sent", "garbled"}, {"lost", kRecover}},
            {{"sent", "link gone"}, {"lost", kRecover}},
            {{"sent", "time up"}, {"lost", kRecover}},

            {{"sent again", "ACC"}, {"accepted", kWait}},
            {{"sent again", "DONE"}, {"done", kFinish}},
            {{"sent again", "ERR 200"}, {"failed refused", kFinish}},
            {{"sent again", "ERR 304"}, {"failed stale", kFinish}},
            {{"sent again", "ERR 410"}, {"failed stopped", kFinish}},
            // The first line may have been understood.
            {{"sent again", "ERR 0"}, {"lost", kRecover}},
            {{"sent again", "garbled"}, {"lost", kRecover}},
            {{"sent again", "link gone"}, {"lost", kRecover}},
            {{"sent again", "time up"}, {"lost", kRecover}},

            {{"sent last", "ACC"}, {"accepted", kWait}},
            {{"sent last", "DONE"}, {"done", kFinish}},
            {{"sent last", "ERR 200"}, {"failed refused", kFinish}},
            {{"sent last", "ERR 304"}, {"failed stale", kFinish}},
            {{"sent last", "ERR 410"}, {"failed stopped", kFinish}},
            {{"sent last", "ERR 0"}, {"failed lost", kFinish}},
            {{"sent last", "garbled"}, {"failed lost", kFinish}},
            {{"sent last", "link gone"}, {"failed lost", kFinish}},
            {{"sent last", "time up"}, {"failed timeout", kFinish}},

            {{"accepted", "DONE"}, {"done", kFinish}},
            {{"accepted", "ERR 200"}, {"failed refused", kFinish}},
            {{"accepted", "ERR 304"}, {"failed stale", kFinish}},
            {{"accepted", "ERR 410"}, {"failed stopped", kFinish}},
            {{"accepted", "ERR 0"}, {"lost", kRecover}},
            {{"accepted", "garbled"}, {"lost", kRecover}},
            {{"accepted", "link gone"}, {"lost", kRecover}},
            {{"accepted", "time up"}, {"lost", kRecover}},

            {{"accepted last", "DONE"}, {"done", kFinish}},
            {{"accepted last", "ERR 200"}, {"failed refused", kFinish}},
            {{"accepted last", "ERR 304"}, {"failed stale", kFinish}},
            {{"accepted last", "ERR 410"}, {"failed stopped", kFinish}},
            {{"accepted last", "ERR 0"}, {"failed lost", kFinish}},
            {{"accepted last", "garbled"}, {"failed lost", kFinish}},
            {{"accepted last", "link gone"}, {"failed lost", kFinish}},
            {{"accepted last", "time up"}, {"failed timeout", kFinish}},

            {{"lost", "link back"}, {"sent1", kSend}},
            {{"lost", "stands still"}, {"failed stopped", kFinish}},
            {{"lost", "gave up"}, {"failed lost", kFinish}},
            {{"late", "link back"}, {"sent1", kSend}},
            {{"late", "stands still"}, {"failed stopped", kFinish}},
            {{"late", "gave up"}, {"failed timeout", kFinish}},
        };
    return all;
}

TEST(GspExchange, EveryStateKnowsWhatToMakeOfEverything) {
    std::size_t met = 0;
    for (const auto& [state_name, state] : states()) {
        for (const auto& [input_name, input] : inputs()) {
            const TurnStep result = step(state, input, kRules);
            const auto row = table().find({state_name, input_name});
            if (row == table().end()) {
                EXPECT_FALSE(result.expected) << state_name << ", " << input_name;
                EXPECT_EQ(name_of(result.state), name_of(state))
                    << "changed by " << input_name << " in " << state_name;
                EXPECT_NE(result.action, TurnAction::kSend) << state_name << ", " << input_name;
                continue;
            }
            ++met;
            EXPECT_TRUE(result.expected) << state_name << ", " << input_name;
            EXPECT_EQ(name_of(result.state), row->second.first) << state_name << ", " << input_name;
            EXPECT_EQ(result.action, row->second.second) << state_name << ", " << input_name;
        }
    }
    EXPECT_EQ(met, table().size()) << "a row of the table names no state or no input";
}

TEST(GspExchange, OnlyALossThatWasHealedSendsAgainAndNotForEver) {
    TurnState state = step(TurnIdle{}, Begin{}, kRules).state;
    for (int recovery = 0; recovery < kRules.max_recoveries; ++recovery) {
        state = step(state, TimeUp{trouble(RobotFault::kTimeout)}, kRules).state;
        const TurnStep again = step(state, LinkBack{}, kRules);
        EXPECT_EQ(again.action, TurnAction::kSend);
        state = again.state;
    }
    const TurnStep last = step(state, TimeUp{trouble(RobotFault::kTimeout)}, kRules);
    ASSERT_TRUE(std::holds_alternative<TurnFailed>(last.state));
    const RobotError error = std::get<TurnFailed>(last.state).error;
    EXPECT_TRUE(error.motion_unknown());
    EXPECT_THAT(error.message, HasSubstr("turn 17"));
    EXPECT_THAT(error.message, HasSubstr("the cable is out"));
}

TEST(GspExchange, AStaleIdTellsWhereToGoOn) {
    const auto result = step(TurnSent{}, inputs().at("ERR 304"), kRules);
    EXPECT_EQ(std::get<TurnFailed>(result.state).error.last_id, 40);
}

TEST(GspExchange, AStaleIdThatLeadsNowhereIsNotAskedAgain) {
    struct Case {
        std::string text;
        RobotFault fault;
    };
    for (const auto& [text, fault] : std::vector<Case>{
             {"last=17 other arguments", RobotFault::kStaleId},
             {"last=16 passed", RobotFault::kProtocol},
             {"last=0", RobotFault::kProtocol},
             {"last=4000000000", RobotFault::kProtocol},
             {"passed", RobotFault::kProtocol},
             {fmt::format("last={}", kGreatestId - 1), RobotFault::kStaleId},
             {fmt::format("last={}", kGreatestId), RobotFault::kRefused},
             {"last=2147483647", RobotFault::kRefused},
         }) {
        const auto result =
            step(TurnSent{}, Reply(Failure{kId, ErrorCode::kStaleId, text}), kRules);
        const RobotError& error = std::get<TurnFailed>(result.state).error;
        EXPECT_EQ(error.fault, fault) << text;
        EXPECT_EQ(error.code, 304) << text;
        EXPECT_THAT(error.message, HasSubstr(text));
    }
}

}  // namespace
}  // namespace gripscan::gsp
