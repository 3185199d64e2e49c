#include "core/robot/gsp_message.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/base/seeded_random.h"
#include "core/robot/line_framer.h"
#include "tests/support/comma_locale.h"

namespace gripscan::gsp {
namespace {

using testing::HasSubstr;

constexpr const char* kDone =
    "DONE 17 POS 124910 0.0000 0.0000 0.0000 0.0000 -90.0000 29.9980 485.0000 0.0000 395.0000 "
    "180.0000 0.0000 29.9980 0 1";

TEST(GspMessage, EncodesTheExamplesOfTheSpecification) {
    EXPECT_EQ(encode(Request(Hello{})), "HELLO 1");
    EXPECT_EQ(encode(Request(AskState{})), "STATE");
    EXPECT_EQ(encode(Request(AskPosition{})), "POS");
    EXPECT_EQ(encode(Request(Stop{})), "STOP");
    EXPECT_EQ(encode(Request(TurnJoint6{17, 30.0, 10.0})), "J6ABS 17 30.0000 10");
    EXPECT_EQ(encode(Request(TurnJoint6{17, -0.00001, 12.5})), "J6ABS 17 0.0000 12.5");
    EXPECT_EQ(encode(Reply(HelloReply{"LRMate200iC/5L", 6, "GSP/1.0"})),
              "OK HELLO LRMate200iC/5L 6 GSP/1.0");
    EXPECT_EQ(encode(Reply(StateReply{true, true, false, false, false, 100, ""})),
              "OK STATE 1 1 0 0 0 100 -");
    EXPECT_EQ(encode(Reply(StateReply{{}, true, {}, true, false, {}, "SRVO-002 Teach pendant"})),
              "OK STATE - 1 - 1 0 - SRVO-002 Teach pendant");
    EXPECT_EQ(encode(Reply(Accepted{17})), "OK ACC 17");
    EXPECT_EQ(encode(Reply(StopReply{})), "OK STOP");
    EXPECT_EQ(encode(Reply(Failure{17, ErrorCode::kStopped, "stopped on request"})),
              "ERR 17 410 stopped on request");
}

TEST(GspMessage, EveryReplyOfTheSpecificationReadsBackToItsOwnText) {
    for (const std::string line :
         {"OK HELLO LRMate200iC/5L 6 GSP/1.0", "OK STATE 1 0 1 0 1 0 SRVO-002",
          "OK STATE - - - - - - -", "OK ACC 2147483647", "OK STOP", "ERR 0 100 malformed line",
          "ERR 21 304 last=20 stale", "ERR 5 500", kDone, "OK POS - - - - - - - - - - - - - - -"}) {
        const auto reply = decode_reply(line);
        ASSERT_TRUE(reply) << line;
        EXPECT_EQ(encode(*reply), line);
    }
}

TEST(GspMessage, EveryRequestReadsBackToItsOwnText) {
    for (const std::string line : {"HELLO 1", "HELLO 2", "STATE", "POS", "STOP",
                                   "J6ABS 1 -180.0000 1", "J6ABS 2147483647 0.0001 99.5"}) {
        const auto request = decode_request(line);
        ASSERT_TRUE(request) << line;
        EXPECT_EQ(encode(*request), line);
    }
}

TEST(GspMessage, ReadsTheNumbersOfADone) {
    const auto reply = decode_reply(kDone);
    ASSERT_TRUE(reply);
    const auto& done = std::get<Done>(*reply);
    EXPECT_EQ(done.id, 17);
    EXPECT_EQ(done.position.time_ms, 124910);
    EXPECT_EQ(done.position.joints_deg[4], -90.0);
    EXPECT_EQ(done.position.joints_deg[5], 29.998);
    EXPECT_EQ(done.position.xyzwpr[0], 485.0);
    EXPECT_EQ(done.position.xyzwpr[5], 29.998);
    EXPECT_EQ(done.position.uframe, 0);
    EXPECT_EQ(done.position.utool, 1);
}

TEST(GspMessage, SpacesBetweenWordsAreAsManyAsTheControllerLikes) {
    // KAREL writes numbers with leading blanks.
    EXPECT_EQ(std::get<TurnJoint6>(*decode_request(" J6ABS  17    30.5   10 ")),
              (TurnJoint6{17, 30.5, 10.0}));
    EXPECT_EQ(std::get<Failure>(*decode_reply("ERR  3  203  SRVO-002  deadman ")).text,
              "SRVO-002  deadman");
}

TEST(GspMessage, RefusesMalformedRequestsWithTheCodeTheyDeserve) {
    struct Case {
        std::string line;
        int id;
        ErrorCode code;
    };
    for (const auto& [line, id, code] : std::vector<Case>{
             {"", 0, ErrorCode::kUnknownRequest},
             {"JUMP", 0, ErrorCode::kUnknownRequest},
             {"pos", 0, ErrorCode::kUnknownRequest},
             {"POS 1", 0, ErrorCode::kMalformed},
             {"STATE now", 0, ErrorCode::kMalformed},
             {"HELLO", 0, ErrorCode::kMalformed},
             {"HELLO one", 0, ErrorCode::kMalformed},
             {"J6ABS", 0, ErrorCode::kMalformed},
             {"J6ABS 0 30 10", 0, ErrorCode::kMalformed},
             {"J6ABS -3 30 10", 0, ErrorCode::kMalformed},
             {"J6ABS 2147483648 30 10", 0, ErrorCode::kMalformed},
             {"J6ABS 17", 17, ErrorCode::kMalformed},
             {"J6ABS 17 30", 17, ErrorCode::kMalformed},
             {"J6ABS 17 30 10 5", 17, ErrorCode::kMalformed},
             {"J6ABS 17 3e1 10", 17, ErrorCode::kMalformed},
             {"J6ABS 17 nan 10", 17, ErrorCode::kMalformed},
             {"J6ABS 17 inf 10", 17, ErrorCode::kMalformed},
             {"J6ABS 17 - 10", 17, ErrorCode::kMalformed},
             {"J6ABS 17 30,5 10", 17, ErrorCode::kMalformed},
             {"J6ABS 17 .5 10", 17, ErrorCode::kMalformed},
             {"J6ABS 17 5. 10", 17, ErrorCode::kMalformed},
             {"J6ABS 17 +5 10", 17, ErrorCode::kMalformed},
             {"J6ABS 17 0x10 10", 17, ErrorCode::kMalformed},
             {"J6ABS 17 1.2.3 10", 17, ErrorCode::kMalformed},
             {"POS\t", 0, ErrorCode::kMalformed},
             {std::string(201, 'P'), 0, ErrorCode::kMalformed},
         }) {
        const auto request = decode_request(line);
        ASSERT_FALSE(request) << line;
        EXPECT_EQ(request.error().id, id) << line;
        EXPECT_EQ(request.error().code, code) << line;
    }
}

TEST(GspMessage, RefusesRepliesThatAreNone) {
    for (const std::string line : {"",
                                   "OK",
                                   "OK FINE",
                                   "OK ACC",
                                   "OK ACC 0",
                                   "OK ACC x",
                                   "OK ACC 1 2",
                                   "OK STOP now",
                                   "OK HELLO LRMate 6",
                                   "OK HELLO LRMate six GSP/1.0",
                                   "OK STATE 1 1 0 0 0 100",
                                   "OK STATE 2 1 0 0 0 100 -",
                                   "OK STATE 1 1 0 0 0 101 -",
                                   "OK POS 1 2 3",
                                   "OK POS 1 0 0 0 0 0 0 0 0 0 0 0 0 0 1 1",
                                   "OK POS 1 0 0 0 0 0 1e3 0 0 0 0 0 0 0 1",
                                   "DONE 17",
                                   "DONE 17 STATE",
                                   "ERR",
                                   "ERR 1",
                                   "ERR 1 x",
                                   "ERR 1 99 low",
                                   "ERR -1 100 x",
                                   "0:success"}) {
        const auto reply = decode_reply(line);
        ASSERT_FALSE(reply) << line;
        EXPECT_EQ(reply.error().fault, RobotFault::kProtocol);
        EXPECT_THAT(reply.error().message, HasSubstr("'" + line + "'"));
    }
}

TEST(GspMessage, NoLineIsLongerThanAllowedWhateverIsInIt) {
    Position position;
    position.time_ms = std::numeric_limits<std::int64_t>::min();
    position.joints_deg.fill(-99999.99994);
    position.xyzwpr.fill(-99999.99994);
    position.uframe = position.utool = 99;
    const std::string done = encode(Reply(Done{2147483647, position}));
    EXPECT_LE(done.size(), kLongestLine);
    EXPECT_TRUE(decode_reply(done)) << "nothing of it may be cut: " << done;

    position.joints_deg[3] = 1e300;
    position.joints_deg[4] = std::nan("");
    const auto again = decode_reply(encode(Reply(PositionReply{position})));
    ASSERT_TRUE(again) << "no exponent may appear";
    EXPECT_FALSE(std::get<PositionReply>(*again).position.joints_deg[3]);
    EXPECT_FALSE(std::get<PositionReply>(*again).position.joints_deg[4]);

    const std::string error =
        encode(Reply(Failure{1, ErrorCode::kFault, std::string(300, 'x') + "\nÄ"}));
    EXPECT_EQ(error.size(), kLongestLine);
    EXPECT_EQ(encode(Reply(Failure{1, ErrorCode::kFault, "a\r\nb\xC4"})), "ERR 1 203 a??b?");
}

TEST(GspMessage, NumbersKeepTheirPointInAnyLocale) {
    const test::CommaLocale locale;
    EXPECT_EQ(encode(Request(TurnJoint6{1, 30.5, 12.5})), "J6ABS 1 30.5000 12.5");
    EXPECT_EQ(std::get<TurnJoint6>(*decode_request("J6ABS 1 30.5 12.5")).angle_deg, 30.5);
}

TEST(GspMessage, RandomBytesNeverBreakTheReaders) {
    SeededRandom random(5);
    const std::string base = kDone;
    for (int trial = 0; trial < 5000; ++trial) {
        std::string line = base;
        for (int change = 0; change < 3; ++change) {
            const auto at = static_cast<std::size_t>(random.uniform(0.0, 0.999) *
                                                     static_cast<double>(line.size()));
            line[at] = static_cast<char>(random.uniform(0.0, 256.0));
        }
        if (const auto reply = decode_reply(line)) {
            EXPECT_EQ(encode(*decode_reply(encode(*reply))), encode(*reply));
        }
        (void)decode_request(line);
    }
}

TEST(GspError, TheTableHasEveryCodeOnceAndRising) {
    int last = 0;
    for (const ErrorRow& row : error_table()) {
        EXPECT_GT(static_cast<int>(row.code), last);
        last = static_cast<int>(row.code);
        EXPECT_EQ(fault_of(row.code), row.fault);
        EXPECT_FALSE(row.words.empty());
    }
    EXPECT_EQ(error_table().size(), 18U);
}

TEST(GspError, CodesTellWhatMayBeDoneNext) {
    EXPECT_EQ(fault_of(ErrorCode::kBusy), RobotFault::kRefused);
    EXPECT_EQ(fault_of(ErrorCode::kTargetRange), RobotFault::kOutOfRange);
    EXPECT_EQ(fault_of(ErrorCode::kStopped), RobotFault::kStopped);
    EXPECT_EQ(fault_of(ErrorCode::kOffTarget), RobotFault::kOffTarget);
    EXPECT_EQ(fault_of(ErrorCode{250}), RobotFault::kRefused) << "unlisted: by its hundreds";
    EXPECT_EQ(fault_of(ErrorCode{999}), RobotFault::kInternal);
}

TEST(GspError, AStaleIdNamesTheLastOne) {
    const RobotError error = robot_error(ErrorCode::kStaleId, stale_text(41, "passed"));
    EXPECT_EQ(error.fault, RobotFault::kStaleId);
    EXPECT_EQ(error.last_id, 41);
    EXPECT_EQ(error.code, 304);
    EXPECT_EQ(last_id_in("last=7"), 7);
    for (const char* none :
         {"", "last=", "last=x", "last=7x", "last=-1", "last=99999999999", "the last=7"}) {
        EXPECT_FALSE(last_id_in(none)) << none;
    }
}

}  // namespace
}  // namespace gripscan::gsp
