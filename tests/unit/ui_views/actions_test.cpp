#include "ui/views/actions.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>

#include "core/procedure/step.h"
#include "tests/support/sample_snapshot.h"

namespace gripscan::ui {
namespace {

using namespace gripscan::test;

template <typename C>
bool gives(const Requests& requests) {
    if (requests.size() != 1) return false;
    const auto* give = std::get_if<request::Give>(&requests[0]);
    return give != nullptr && std::holds_alternative<C>(give->command);
}

TEST(Actions, HaveDifferentNamesAndDifferentKeys) {
    std::set<std::string_view> names;
    std::set<std::string_view> keys;
    for (const Action& a : actions()) {
        EXPECT_TRUE(names.insert(a.name).second) << a.name;
        EXPECT_TRUE(a.key.empty() || keys.insert(a.key).second) << a.key;
        EXPECT_FALSE(a.label.empty()) << a.name;
        EXPECT_FALSE(a.tooltip.empty()) << a.name;
        EXPECT_NE(a.key, "Space") << "it belongs to whatever is next";
    }
}

TEST(Actions, EveryCommandWithoutAnArgumentHasOne) {
    for (const Command& command :
         {Command{command::Connect{}}, Command{command::CheckCell{}}, Command{command::WarmUp{}},
          Command{command::Capture{}}, Command{command::Step{}}, Command{command::Retry{}},
          Command{command::Halve{}}, Command{command::LockAxis{}}, Command{command::Accept{}},
          Command{command::Back{}}, Command{command::Undo{}}, Command{command::Redo{}},
          Command{command::Run{}}, Command{command::Pause{}}, Command{command::Stop{}},
          Command{command::Resume{}}, Command{command::Finish{}}}) {
        EXPECT_NE(action_of(command), nullptr) << gripscan::word(command);
    }
    EXPECT_EQ(action_of(command::Exclude{}), nullptr);
    EXPECT_THROW((void)action("step.nothing"), std::out_of_range);
}

TEST(Actions, AreRefusedWithTheReasonOfTheProcedure) {
    const Sample sample = sample_empty();
    for (const char* name : {"step.step", "step.capture", "step.retry", "step.halve"}) {
        EXPECT_EQ(action(name).refusal(sample.snapshot), "not connected: connect first") << name;
    }
    EXPECT_EQ(action("step.connect").refusal(sample.snapshot), std::nullopt);
    EXPECT_EQ(action("window.export").refusal(sample.snapshot),
              "it is made when the turn is solved: finish the turn first");
    EXPECT_EQ(action("table.copy").refusal(sample.snapshot), "there is no step yet");
    EXPECT_EQ(action("window.screenshot").refusal(sample.snapshot), std::nullopt);
}

TEST(Actions, OfARecordingAreOnlyThoseThatLook) {
    Sample sample = sample_rejected();
    sample.snapshot.session->recorded = true;
    for (const Action& a : actions()) {
        const bool commands = a.name.starts_with("step.");
        EXPECT_TRUE(!commands || a.refusal(sample.snapshot)) << a.name;
    }
    EXPECT_FALSE(action("table.copy").refusal(sample.snapshot));
    EXPECT_EQ(next_action(sample.snapshot), nullptr);
    EXPECT_TRUE(requests_for_key("Space", sample.snapshot).empty());
}

TEST(Actions, WithoutASessionNothingIsCommanded) {
    const Snapshot nothing;
    EXPECT_EQ(action("step.stop").refusal(nothing), "no session is open");
    EXPECT_EQ(next_action(nothing), nullptr);
    EXPECT_FALSE(action("window.new").refusal(nothing));
}

TEST(NextAction, IsTheOneOfTheProcedureThroughAWholeTurn) {
    struct Row {
        Sample sample;
        const char* next;
        const char* label;
    };
    const std::vector<Row> rows{{sample_empty(), "step.connect", "Connect"},
                                {sample_cell_checked(), "step.warm_up", "Find the axis"},
                                {sample_running(), "step.step", "Step +10° and capture"},
                                {sample_rejected(), "step.halve", "Halve to 5° and capture"},
                                {sample_link_lost(), "step.resume", "Resume"},
                                {sample_finished(), "window.export", "Export the template"}};
    for (const Row& row : rows) {
        const Action* next = next_action(row.sample.snapshot);
        ASSERT_NE(next, nullptr) << row.next;
        EXPECT_EQ(next->name, row.next);
        EXPECT_EQ(next_label(*next, row.sample.snapshot), row.label);
        EXPECT_FALSE(next->refusal(row.sample.snapshot)) << "what is next can be done";
    }
    EXPECT_EQ(next_action(sample_aligning().snapshot), nullptr);
}

TEST(NextAction, NamesTheStepThatIsLeftAtTheEndOfATurn) {
    Sample sample = sample_running();
    sample.state->data.step_rad = 0.7 * 3.14159265358979;  // 126°: 140° + 126° + 94°
    EXPECT_EQ(next_label(action("step.step"), sample.snapshot), "Step +126° and capture");
    sample.state->plan.total_rad = 150.5 * 3.14159265358979 / 180.0;
    EXPECT_EQ(next_label(action("step.step"), sample.snapshot), "Step +10.50° and capture");
}

TEST(SecondAdvice, IsShownOnlyWhileAStepIsDecided) {
    EXPECT_EQ(second_advice(sample_rejected().snapshot)->name, "step.retry");
    EXPECT_EQ(second_advice(sample_running().snapshot), nullptr);
    Sample retake = sample_rejected();
    std::get<phase::Deciding>(retake.state->phase).advice.action = AdvisedAction::kRetake;
    EXPECT_EQ(second_advice(retake.snapshot)->name, "step.halve");
}

TEST(Keys, AskForWhatTheirActionDoes) {
    const Sample sample = sample_rejected();
    EXPECT_TRUE(gives<command::Halve>(requests_for_key("Space", sample.snapshot)));
    EXPECT_TRUE(gives<command::Halve>(requests_for_key("H", sample.snapshot)));
    EXPECT_TRUE(gives<command::Retry>(requests_for_key("R", sample.snapshot)));
    EXPECT_TRUE(gives<command::Back>(requests_for_key("B", sample.snapshot)));
    const Requests accept = requests_for_key("A", sample.snapshot);
    ASSERT_EQ(accept.size(), 1U);
    EXPECT_EQ(std::get<request::Show>(accept[0]).dialog, Dialog::kNote) << "a note is asked for";
    EXPECT_TRUE(requests_for_key("C", sample.snapshot).empty()) << "there is a view already";
    EXPECT_TRUE(requests_for_key("Ctrl+F17", sample.snapshot).empty());
    EXPECT_TRUE(gives<command::Stop>(requests_for_key("Esc", sample_aligning().snapshot)));
}

TEST(Keys, CommandWhatThePageShows) {
    Sample sample = sample_running();
    for (const Page page : {Page::kTemplate, Page::kCell, Page::kStart}) {
        sample.snapshot.page = page;
        EXPECT_TRUE(requests_for_key("Space", sample.snapshot).empty());
        EXPECT_TRUE(requests_for_key("S", sample.snapshot).empty());
        EXPECT_TRUE(gives<command::Stop>(requests_for_key("Esc", sample.snapshot)));
    }
    sample.snapshot.page = Page::kProcedure;
    EXPECT_TRUE(gives<command::Step>(requests_for_key("Space", sample.snapshot)));
    sample.snapshot.dialog = Dialog::kSettings;
    EXPECT_TRUE(requests_for_key("Space", sample.snapshot).empty());
    EXPECT_TRUE(requests_for_key("Ctrl+E", sample.snapshot).empty());
    EXPECT_TRUE(gives<command::Stop>(requests_for_key("Esc", sample.snapshot)))
        << "over a dialog, too";
}

TEST(Keys, CanBeChangedAndTheOldOneIsFreeThen) {
    Sample sample = sample_rejected();
    sample.snapshot.preferences.keys = {{"step.retry", "W"}};
    EXPECT_TRUE(requests_for_key("R", sample.snapshot).empty());
    EXPECT_TRUE(gives<command::Retry>(requests_for_key("W", sample.snapshot)));
    EXPECT_EQ(owner_of("W", sample.snapshot.preferences)->name, "step.retry");
    sample.snapshot.preferences.keys = {{"step.retry", "Space"}};
    EXPECT_TRUE(gives<command::Halve>(requests_for_key("Space", sample.snapshot)))
        << "Space stays with the next action";
}

TEST(Zoom, GoesUpAndDownByTheSameFactor) {
    Sample sample = sample_empty();
    const Requests larger = requests_for_key("Ctrl++", sample.snapshot);
    ASSERT_EQ(larger.size(), 1U);
    sample.snapshot.preferences.user_scale = std::get<request::SetScale>(larger[0]).factor;
    EXPECT_GT(sample.snapshot.preferences.user_scale, 1.0);
    const Requests smaller = requests_for_key("Ctrl+-", sample.snapshot);
    ASSERT_EQ(smaller.size(), 1U);
    EXPECT_NEAR(std::get<request::SetScale>(smaller[0]).factor, 1.0, 1e-12);
}

}  // namespace
}  // namespace gripscan::ui
