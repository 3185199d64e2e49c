#include "app/workstation/turn_log.h"

#include <gmock/gmock.h>

namespace gripscan::app {
namespace {
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

JudgedStep judged(int from, int to, Verdict verdict, std::string sentence) {
    JudgedStep step;
    step.row.from = from;
    step.row.to = to;
    step.row.verdict = verdict;
    step.row.sentence = std::move(sentence);
    return step;
}

ProcedureState two_views() {
    ProcedureState state;
    state.phase = phase::Idle{};
    for (int i = 0; i < 2; ++i) {
        CaptureRecord capture;
        capture.index = i;
        state.data.captures.push_back(capture);
    }
    return state;
}

TEST(TurnLog, TellsEveryThingOnce) {
    TurnLog log;
    ProcedureState state = two_views();
    EXPECT_THAT(log.news(state), SizeIs(2));
    EXPECT_THAT(log.news(state), IsEmpty());
    state.judged[{0, 1}] = judged(0, 1, Verdict::kAccept, "ICP turned 9.99°");
    const auto news = log.news(state);
    ASSERT_THAT(news, SizeIs(1));
    EXPECT_EQ(news[0].code, "REG-001");
    EXPECT_THAT(news[0].text, HasSubstr("0 → 1"));
    EXPECT_THAT(log.news(state), IsEmpty());
}

TEST(TurnLog, AStepJudgedAnewIsToldAnewWithItsOwnLevel) {
    TurnLog log;
    ProcedureState state = two_views();
    state.judged[{0, 1}] = judged(0, 1, Verdict::kReject, "24.3° against 10.0°");
    (void)log.news(state);
    state.judged[{0, 1}] = judged(0, 1, Verdict::kAccept, "ICP turned 9.99°");
    const auto news = log.news(state);
    ASSERT_THAT(news, SizeIs(1));
    EXPECT_EQ(news[0].level, ui::LogLevel::kInformation);
}

TEST(TurnLog, ALostLinkIsAnErrorAndToldAgainWhenItHappensAgain) {
    TurnLog log;
    ProcedureState state;
    state.phase = phase::Offline{"nobody answers", {}};
    auto news = log.news(state);
    ASSERT_THAT(news, SizeIs(1));
    EXPECT_EQ(news[0].code, "LNK-010");
    EXPECT_EQ(news[0].level, ui::LogLevel::kError);
    EXPECT_THAT(log.news(state), IsEmpty());
    state.phase = phase::Idle{};
    EXPECT_THAT(log.news(state), IsEmpty());
    state.phase = phase::Offline{"nobody answers", {}};
    EXPECT_THAT(log.news(state), SizeIs(1));
}

}  // namespace
}  // namespace gripscan::app
