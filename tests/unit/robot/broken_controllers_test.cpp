// Controllers that are broken on purpose, one or more for every check of the conformance script: it
// has to find what is wrong with each, and nothing else.
#include <gmock/gmock.h>

#include <set>

#include "tests/support/mock_bends.h"
#include "tests/unit/robot/conformance_run.h"

namespace gripscan::gsp {
namespace {

using test::Flaw;
using test::MockController;
using test::Side;
using Names = std::vector<std::string>;

struct Broken {
    std::string what;
    Names failing;  ///< the checks that fail, all of them
    std::function<void(MockController&)> how;
};

void PrintTo(const Broken& broken, std::ostream* out) {
    *out << broken.what;
}

Broken with_flaw(std::string what, Names failing, Flaw flaw) {
    return {std::move(what), std::move(failing), [=](MockController& c) { c.flaw(flaw); }};
}
Broken hearing(std::string what, Names failing, test::Bend bend) {
    return {std::move(what), std::move(failing),
            [=](MockController& c) { c.hears(Side::kMotion, bend).hears(Side::kMonitor, bend); }};
}
Broken saying(std::string what, Names failing, Side side, test::Bend bend) {
    return {std::move(what), std::move(failing), [=](MockController& c) { c.says(side, bend); }};
}
Broken saying(std::string what, Names failing, test::Bend bend) {
    return {std::move(what), std::move(failing),
            [=](MockController& c) { c.says(Side::kMotion, bend).says(Side::kMonitor, bend); }};
}

std::vector<Broken> questions() {
    using namespace test;
    return {
        saying("HasFiveAxes", {"hello.motion"}, Side::kMotion, with("5L 6", "5L 5")),
        saying("SpeaksAnotherVersion", {"hello.monitor"}, Side::kMonitor, with("GSP/1.0", "XYZ/9")),
        hearing("GreetsAnyVersion", {"hello.version"}, with("HELLO 99", "HELLO 1")),
        saying("StateLacksAField", {"state"}, Side::kMonitor, with("OK STATE 1", "OK STATE")),
        saying("PositionLacksItsTool", {"position", "frame.joined"}, Side::kMotion,
               with_position_word(14, "")),
        saying("Joint6IsUnknown", {"position.joints"}, with_position_word(6, "-")),
        saying("Joint2IsOutOfItsRange", {"position.joints"}, with_position_word(2, "200.0000")),
        saying("TimeStands", {"position.time"}, with_position_word(0, "12345")),
        saying("SilentOnTheUnknown", {"unknown"}, Side::kMotion, instead_of("ERR 0 101", "")),
        hearing("IgnoresWordsTooMany", {"malformed"}, with(" 1 4\r", " 1\r")),
        saying("MalformedIsUnknown", {"malformed"}, with("100 malformed", "101 malformed")),
        with_flaw("TurnsOnTheMonitor", {"monitor.turn"}, Flaw::kTurnsOnMonitor),
        saying("NothingToStop", {"monitor.stop"}, instead_of("OK STOP", "ERR 0 500 stands")),
    };
}

std::vector<Broken> framing() {
    using namespace test;
    return {
        hearing("OneSpaceOnly", {"frame.spaces"}, with("  ", " ? ")),
        hearing("ALineASegment", {"frame.split"}, with_a_line_a_segment()),
        hearing("OneLineASegment", {"frame.joined"}, without_a_second_line()),
        hearing("NoLineEndButLf", {"frame.ends"}, with("\r", "")),
        hearing("EmptyLinesAreLines", {"frame.ends"}, with("\n\n", "\n?\n")),
        hearing("ClosesOn201Characters", {"frame.long"},
                with(std::string(kLongestLine + 1, 'X'), std::string(kLongestBearable + 1, 'X'))),
        hearing("BearsEndlessLines", {"frame.endless"}, without_characters_beyond(250)),
        hearing("BearsAnyByte", {"frame.ascii"}, without_eighth_bit()),
        with_flaw("OneMonitorClientEver", {"reconnect"}, Flaw::kOneMonitorEver),
    };
}

std::vector<Broken> turning() {
    using namespace test;
    return {
        saying("ServoIsOff", {"move.ready"}, with("STATE 1 1", "STATE 1 0")),
        {"EndsOffTarget", {"move.ids"}, [](MockController& c) { c.reports_joint6_off(0.3); }},
        {"DoesNotTellItsLastId",
         {"move.ids"},
         [](MockController& c) { c.remembers(7).says(Side::kMotion, with("last=", "last ")); }},
        with_flaw("DoneTooEarly",
                  {"move.turn", "move.busy", "move.stop", "move.lost", "move.return"},
                  Flaw::kDoneTooEarly),
        saying("PoseStands", {"move.pose"}, with_position_word(12, "0.0000")),
        with_flaw("ARepeatMoves", {"move.repeat", "move.lost"}, Flaw::kRepeatMoves),
        with_flaw("TakesOtherTurnsOfAnId", {"move.conflict", "move.lost"}, Flaw::kTakesOtherTurns),
        with_flaw("TakesOldIds", {"move.stale"}, Flaw::kTakesOldIds),
        hearing("TakesFarTargets", {"move.range"}, with(" 400.0000 ", " 10.0000 ")),
        hearing("TakesHighSpeeds", {"move.speed"}, with(" 101\r", " 10\r")),
        hearing("TakesNoSpeed", {"move.speed"}, with(" 0\r", " 1\r")),
        saying("NeverTellsThatItMoves", {"move.watch"}, with("STATE 1 1 0 0 1", "STATE 1 1 0 0 0")),
        with_flaw("NeverBusy", {"move.busy"}, Flaw::kNeverBusy),
        with_flaw("DeafToStop", {"move.stop"}, Flaw::kDeafToStop),
        with_flaw("ForgetsIdsOnLoss", {"move.lost"}, Flaw::kForgetsOnLoss),
        with_flaw("StuckAfterLoss", {"move.return"}, Flaw::kStuckAfterLoss),
        {"TurnsJoint5Along", {"move.others"}, [](MockController& c) { c.turns_joint5_along(0.1); }},
    };
}

std::vector<Broken> all() {
    std::vector<Broken> result;
    for (const auto& group : {questions(), framing(), turning()}) {
        result.insert(result.end(), group.begin(), group.end());
    }
    return result;
}

bool moves(const Broken& broken) {
    return broken.failing.front().starts_with("move.");
}

class BrokenController : public testing::TestWithParam<Broken> {};

TEST_P(BrokenController, IsFoundOutForWhatItIs) {
    MockController controller;
    GetParam().how(controller);
    const ConformanceReport report = report_of(controller, moves(GetParam()));
    EXPECT_FALSE(report.conforms());
    EXPECT_EQ(names(report, CheckOutcome::kFailed), GetParam().failing) << failures(report);
}

INSTANTIATE_TEST_SUITE_P(Every, BrokenController, testing::ValuesIn(all()),
                         [](const auto& test) { return test.param.what; });

TEST(BrokenControllers, ThereIsOneForEveryCheckThatRequiresSomething) {
    std::set<std::string> found;
    for (const Broken& broken : all()) found.insert(broken.failing.begin(), broken.failing.end());
    MockController controller;
    for (const ConformanceCheck& check : report_of(controller, false).checks) {
        EXPECT_EQ(found.erase(check.name) == 1, check.required != "nothing") << check.name;
    }
    EXPECT_THAT(found, testing::IsEmpty()) << "names of no check";
}

}  // namespace
}  // namespace gripscan::gsp
