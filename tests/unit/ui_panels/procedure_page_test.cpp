// What the panels around the 3D view emit in the states of a turn.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/base/units.h"
#include "tests/support/sample_snapshot.h"
#include "tests/support/ui_driver.h"
#include "ui/panels/history_panel.h"
#include "ui/panels/keyboard.h"
#include "ui/panels/stage_bar.h"
#include "ui/panels/status_bar.h"
#include "ui/panels/step_card.h"
#include "ui/panels/table_dock.h"
#include "ui/panels/toasts.h"
#include "ui/panels/top_bar.h"
#include "ui/views/actions.h"
#include "ui/views/step_text.h"

namespace gripscan::ui {
namespace {

using namespace gripscan::test;

/// All panels of the page in a window of 1600 × 1000.
class Screen {
  public:
    explicit Screen(Sample sample) : sample_(std::move(sample)) { driver_.frame(); }

    /// What a click asks for.
    Requests click(std::string_view id, ImGuiMouseButton which = ImGuiMouseButton_Left) {
        out_.clear();
        EXPECT_TRUE(driver_.click(id, which)) << id << " is not shown";
        return out_;
    }
    [[nodiscard]] std::optional<WidgetRecord> find(std::string_view id) {
        driver_.frame();
        return driver_.log().find(id);
    }
    Sample& sample() { return sample_; }
    UiDriver& driver() { return driver_; }
    Requests& out() { return out_; }

  private:
    void draw(const Ui& ui) {
        const WindowLayout at = layout_window(1600, 1000, {}, ui.scale);
        const Snapshot& s = sample_.snapshot;
        take_keys(s, false, out_);
        draw_top_bar(ui, at.top_bar, s, out_);
        draw_stage_bar(ui, at.stage_bar, s, at.detail, out_);
        draw_step_card(ui, at.step_card, s, at.detail, card_, out_);
        draw_table_dock(ui, at.table, s, at.detail, dock_, log_, nullptr, out_);
        draw_history_panel(ui, at.history, s, at.detail, log_, out_);
        draw_status_bar(ui, at.status_bar, s, at.detail, std::nullopt, out_);
        draw_toasts(ui, at.view3d, s, out_);
    }

    Sample sample_;
    StepCardState card_;
    TableDockState dock_;
    LogListState log_;
    Requests out_;
    UiDriver driver_{1600, 1000, [this](const Ui& ui) { draw(ui); }};
};

template <typename C>
bool gives(const Requests& requests) {
    if (requests.size() != 1) return false;
    const auto* give = std::get_if<request::Give>(&requests[0]);
    return give != nullptr && std::holds_alternative<C>(give->command);
}

std::vector<Sample (*)()> all_samples() {
    return {sample_empty,    sample_cell_checked, sample_running, sample_rejected,
            sample_finished, sample_link_lost,    sample_aligning};
}

TEST(StepCard, ButtonsAreGreyExactlyWhereTheProcedureRefusesAndSayWhy) {
    int enabled = 0;
    int grey = 0;
    for (const auto& make : all_samples()) {
        Screen page(make());
        int shown = 0;
        for (const char* name : {"step.capture", "step.retry", "step.halve", "step.accept",
                                 "step.back", "step.stop", "step.step"}) {
            const auto button = page.find(name);
            if (!button) continue;  // another action is next, and stands in its place
            ++shown;
            const auto why = action(name).refusal(page.sample().snapshot);
            EXPECT_EQ(button->enabled, !why) << name;
            EXPECT_EQ(button->reason, why.value_or("")) << name;
            ++(button->enabled ? enabled : grey);
        }
        EXPECT_GE(shown, 6);
    }
    EXPECT_GT(enabled, 10);
    EXPECT_GT(grey, 10);
}

TEST(StepCard, EveryEnabledButtonEmitsItsCommandOnce) {
    int emitted = 0;
    for (const auto& make : all_samples()) {
        Screen page(make());
        for (const Action& a : actions()) {
            if (!a.name.starts_with("step.")) continue;
            const auto button = page.find(a.name);
            if (!button) continue;
            const Requests out = page.click(a.name);
            ASSERT_EQ(out.size(), button->enabled ? 1U : 0U) << a.name;
            if (out.empty()) continue;
            ++emitted;
            EXPECT_EQ(out[0].index(), a.request(page.sample().snapshot).index()) << a.name;
        }
    }
    EXPECT_GT(emitted, 10);
}

TEST(StepCard, TheNextActionStandsInTheLargeButtonAndStepInItsPlace) {
    Screen running(sample_running());
    EXPECT_EQ(running.find("step.step")->label, "Step +10° and capture");
    const Rect halve_slot = running.find("step.halve")->rect;
    const Rect large = running.find("step.step")->rect;
    Screen rejected(sample_rejected());
    EXPECT_EQ(rejected.find("step.halve")->label, "Halve to 5° and capture");
    EXPECT_EQ(rejected.find("step.halve")->rect, large);
    EXPECT_EQ(rejected.find("step.step")->rect, halve_slot);
    for (const char* name :
         {"step.capture", "step.retry", "step.accept", "step.back", "step.stop"}) {
        EXPECT_EQ(rejected.find(name)->rect, running.find(name)->rect) << name;
    }
    EXPECT_EQ(rejected.find("step.waits")->label, "Step 6 is to be accepted or taken again.");
}

TEST(StepCard, ALimitIsEditedWhereItIsShownBeforeTheFirstView) {
    Screen page(sample_cell_checked());
    ASSERT_TRUE(page.find("evidence.slip"));
    EXPECT_EQ(page.find("step.evidence_of")->label, "Limits of every step");
    EXPECT_FALSE(page.find("evidence.rms")) << "no plan sets a limit for it";
    (void)page.click("evidence.slip");
    ASSERT_TRUE(page.find("plan.slip"));
    EXPECT_FALSE(page.find("plan.overlap")) << "each line has its own";
    (void)page.click("plan.slip");
    page.out().clear();
    page.driver().type("0.4");
    page.driver().key(ImGuiKey_Enter);
    ASSERT_EQ(page.out().size(), 1U);
    const auto* set = std::get_if<request::SetPlan>(&page.out()[0]);
    ASSERT_NE(set, nullptr);
    EXPECT_NEAR(set->plan.limits.slip_m, 0.0004, 1e-12);
    EXPECT_EQ(set->plan.limits.tilt_rad, page.sample().state->plan.limits.tilt_rad);
    page.sample().state->plan = set->plan;
    const Requests reset = page.click("plan.slip.reset");
    ASSERT_EQ(reset.size(), 1U);
    EXPECT_NEAR(std::get<request::SetPlan>(reset[0]).plan.limits.slip_m, TurnLimits{}.slip_m,
                1e-12);
}

TEST(StepCard, TheAngleErrorHasBothLimitsThatMakeIt) {
    Screen page(sample_cell_checked());
    (void)page.click("evidence.angle_error");
    EXPECT_TRUE(page.find("plan.angle"));
    EXPECT_TRUE(page.find("plan.sigmas"));
}

TEST(StepCard, LimitsStayOnceAViewIsTaken) {
    Screen page(sample_running());
    EXPECT_THAT(page.click("evidence.slip"), testing::IsEmpty());
    EXPECT_FALSE(page.find("plan.slip"));
}

TEST(StepCard, EvidenceOfTheStepBeforeIsCalledSo) {
    Screen aligning(sample_aligning());
    const auto caption = aligning.find("step.evidence_of");
    ASSERT_TRUE(caption);
    EXPECT_THAT(caption->label, testing::HasSubstr("the one before"));
    EXPECT_TRUE(evidence_caption(aligning.sample().snapshot).past);
    Screen running(sample_running());
    EXPECT_FALSE(running.find("step.evidence_of"));
}

/// Without motion rights and without a link that reads.
Sample sample_by_hand() {
    Sample sample = sample_cell_checked();
    sample.state->plan.mode = MotionMode::kManual;
    sample.state->reading.reset();
    sample.snapshot.reading.reset();
    return sample;
}

TEST(StepCard, TheOperatorTellsTheAngleWhereItIsWaitedFor) {
    Sample sample = sample_by_hand();
    Shot shot;
    shot.index = 1;
    sample.state->phase = phase::Busy{activity::AwaitingOperator{rad_from_deg(20.0), shot}};
    Screen page(std::move(sample));
    EXPECT_EQ(page.find("status.mode")->label, "MANUAL");
    ASSERT_TRUE(page.find("step.told_angle"));
    EXPECT_TRUE(page.find("step.told_angle")->enabled);
    (void)page.click("step.told_angle");
    page.out().clear();
    page.driver().type("19.75");
    page.driver().key(ImGuiKey_Enter);
    ASSERT_TRUE(gives<command::TellAngle>(page.out()));
    const auto& give = std::get<request::Give>(page.out()[0]);
    EXPECT_NEAR(std::get<command::TellAngle>(give.command).joint6_rad, rad_from_deg(19.75), 1e-12);
}

TEST(StepCard, WhereTheRobotIsReadNobodyTellsItsAngle) {
    Sample sample = sample_by_hand();
    sample.state->reading.emplace();
    Screen page(std::move(sample));
    EXPECT_FALSE(page.find("step.told_angle")->enabled);
    EXPECT_EQ(page.find("step.told_angle")->reason, "the robot is read");
    Screen simulated(sample_cell_checked());
    EXPECT_FALSE(simulated.find("step.told_angle")) << "only without motion rights";
}

TEST(StepCard, NothingOverlapsInAnyState) {
    for (const auto& make : all_samples()) {
        Screen page(make());
        page.driver().frame();
        const auto records = page.driver().log().records();
        for (std::size_t i = 0; i < records.size(); ++i) {
            for (std::size_t j = 0; j < i; ++j) {
                const bool both =
                    (records[i].id.starts_with("step.") ||
                     records[i].id.starts_with("evidence.")) &&
                    (records[j].id.starts_with("step.") || records[j].id.starts_with("evidence."));
                EXPECT_FALSE(both && records[i].rect.overlaps(records[j].rect))
                    << records[i].id << " and " << records[j].id;
            }
        }
    }
}

TEST(StepCard, RunsAndPauses) {
    Screen page(sample_running());
    EXPECT_TRUE(gives<command::Run>(page.click("mode.run")));
    EXPECT_TRUE(page.click("mode.by_hand").empty());
    Screen running(sample_aligning());
    EXPECT_TRUE(gives<command::Pause>(running.click("mode.by_hand")));
    EXPECT_TRUE(gives<command::Pause>(running.click("step.pause")));
    EXPECT_TRUE(gives<command::Stop>(running.click("step.stop")));
}

TEST(StepCard, HoldToMoveIsThereInLiveOnlyAndTellsBothEnds) {
    Screen page(sample_running());
    EXPECT_FALSE(page.find("live.hold"));
    set_mode(page.sample(), MotionMode::kLive);
    ASSERT_TRUE(page.find("live.hold"));
    ASSERT_TRUE(page.driver().hover("live.hold"));
    page.out().clear();
    page.driver().press(ImGuiMouseButton_Left, true);
    ASSERT_EQ(page.out().size(), 1U);
    EXPECT_TRUE(std::get<request::HoldToMove>(page.out()[0]).held);
    page.driver().frame();
    EXPECT_EQ(page.out().size(), 1U) << "once";
    page.driver().press(ImGuiMouseButton_Left, false);
    ASSERT_EQ(page.out().size(), 2U);
    EXPECT_FALSE(std::get<request::HoldToMove>(page.out()[1]).held);
}

TEST(TableDock, AClickOnARowSelectsItsStepAndOnTheLastFollows) {
    Screen page(sample_rejected());
    const Requests out = page.click("table.row2");
    ASSERT_EQ(out.size(), 1U);
    EXPECT_EQ(std::get<request::SelectStep>(out[0]).row, 2U);
    const Requests last = page.click("table.row5");
    ASSERT_EQ(last.size(), 1U);
    EXPECT_EQ(std::get<request::SelectStep>(last[0]).row, std::nullopt);
}

TEST(TableDock, TheMenuOfARowTakesItAgainOrLeavesItOut) {
    Screen page(sample_rejected());
    (void)page.click("table.row2", ImGuiMouseButton_Right);
    const Requests retake = page.click("row.retake");
    ASSERT_TRUE(gives<command::Retake>(retake));
    EXPECT_EQ(std::get<command::Retake>(std::get<request::Give>(retake[0]).command).index, 3);
    EXPECT_FALSE(page.find("row.retake")) << "the menu is closed";
    (void)page.click("table.row2", ImGuiMouseButton_Right);
    EXPECT_EQ(page.find("row.note")->reason, "only the last step can be accepted");
    EXPECT_TRUE(gives<command::Exclude>(page.click("row.exclude")));
}

TEST(TableDock, CopiesAndSaves) {
    Screen page(sample_running());
    const Requests copy = page.click("table.copy");
    ASSERT_EQ(copy.size(), 1U);
    EXPECT_EQ(std::get<request::CopyText>(copy[0]).what, "Table 1");
    EXPECT_THAT(page.find("table.csv")->reason, testing::HasSubstr("finish the turn first"));
    Screen finished(sample_finished());
    const Requests save = finished.click("table.csv");
    ASSERT_EQ(save.size(), 1U);
    EXPECT_TRUE(std::holds_alternative<request::SaveTable>(save[0]));
    Screen empty(sample_empty());
    EXPECT_EQ(empty.find("table.copy")->reason, "there is no step yet");
}

TEST(TableDock, ItsTabsShowImagesAndAttempts) {
    Screen page(sample_rejected());
    EXPECT_TRUE(page.click("dock.attempts").empty());
    EXPECT_TRUE(page.find("attempts.row0"));
    EXPECT_FALSE(page.find("table.row0"));
    EXPECT_TRUE(page.click("dock.images").empty());
    EXPECT_FALSE(page.find("attempts.row0"));
    EXPECT_FALSE(page.find("dock.log")) << "the log has a panel of its own";
}

TEST(Log, ItsFilterGoesThroughTheLevelsAndCopiesWhatIsShown) {
    Screen page(sample_rejected());
    (void)page.click("log.level");
    (void)page.click("log.level");
    const Requests copy = page.click("log.copy");
    ASSERT_EQ(copy.size(), 1U);
    EXPECT_THAT(std::get<request::CopyText>(copy[0]).text, testing::HasSubstr("REG-012"));
    EXPECT_THAT(std::get<request::CopyText>(copy[0]).text,
                testing::Not(testing::HasSubstr("CAM-021")));
}

TEST(Bars, LeadToThePagesAndTools) {
    Screen page(sample_running());
    const auto goes_to = [&](const char* id) {
        const Requests out = page.click(id);
        return out.size() == 1 ? std::get<request::GoTo>(out[0]).page : Page::kStart;
    };
    EXPECT_EQ(goes_to("page.template"), Page::kTemplate);
    EXPECT_EQ(goes_to("stage.cell"), Page::kCell);
    EXPECT_EQ(goes_to("stage.export"), Page::kTemplate);
    const Requests theme = page.click("window.theme");
    ASSERT_EQ(theme.size(), 1U);
    EXPECT_EQ(std::get<request::SetTheme>(theme[0]).theme, ThemeChoice::kLight);
    const Requests keys = page.click("window.keys");
    ASSERT_EQ(keys.size(), 1U);
    EXPECT_EQ(std::get<request::Show>(keys[0]).dialog, Dialog::kKeys);
    EXPECT_EQ(page.find("step.undo")->reason, "there is nothing to undo");
}

TEST(StatusBar, NamesTheModeAndCancelsTheJob) {
    Screen page(sample_aligning());
    EXPECT_EQ(page.find("status.mode")->label, "SIM");
    EXPECT_EQ(page.find("status.robot")->label, "Aligning");
    const Requests cancel = page.click("job.cancel");
    ASSERT_EQ(cancel.size(), 1U);
    EXPECT_TRUE(std::holds_alternative<request::CancelJob>(cancel[0]));
    page.sample().snapshot.job->can_cancel = false;
    EXPECT_FALSE(page.find("job.cancel"));
    set_mode(page.sample(), MotionMode::kLive);
    EXPECT_EQ(page.find("status.mode")->label, "LIVE");
}

TEST(Toasts, AreClosedByTheirCross) {
    Screen page(sample_running());
    page.sample().snapshot.toasts = {{"saved", LogLevel::kInformation, "Table 1 saved", "a.csv"},
                                     {"low", LogLevel::kWarning, "Disk is nearly full", "2 GB"}};
    const Requests close = page.click("toast.saved.close");
    ASSERT_EQ(close.size(), 1U);
    EXPECT_EQ(std::get<request::CloseToast>(close[0]).id, "saved");
    EXPECT_LT(page.find("toast.saved")->rect.y, page.find("toast.low")->rect.y)
        << "the newest is at the bottom";
}

/// A key with its letter, as the window hands them on.
void press(UiDriver& driver, int number, std::string_view typed) {
    ImGui::GetIO().KeysDown[number] = true;
    driver.type(typed);
    ImGui::GetIO().KeysDown[number] = false;
    driver.frame();
}

TEST(Keyboard, SpacePressesTheNextActionAndLettersTheirs) {
    Screen page(sample_rejected());
    page.out().clear();
    press(page.driver(), ' ', " ");
    EXPECT_TRUE(gives<command::Halve>(page.out()));
    page.out().clear();
    press(page.driver(), 'Q', "r");  // the letter counts, not the place of the key
    EXPECT_TRUE(gives<command::Retry>(page.out()));
}

TEST(Keyboard, AHeldKeyActsOnce) {
    Screen page(sample_rejected());
    page.out().clear();
    ImGui::GetIO().KeysDown[int{'R'}] = true;
    page.driver().type("r");
    page.driver().type("r");
    page.driver().type("r");
    EXPECT_EQ(page.out().size(), 1U);
}

TEST(Keyboard, IsLeftToADialogThatIsOpen) {
    Screen page(sample_rejected());
    page.sample().snapshot.dialog = Dialog::kNote;
    page.out().clear();
    press(page.driver(), 'R', "r");
    press(page.driver(), ' ', " ");
    EXPECT_TRUE(page.out().empty());
}

TEST(Keyboard, EscapeStops) {
    Screen page(sample_aligning());
    page.out().clear();
    page.driver().key(ImGuiKey_Escape);
    EXPECT_TRUE(gives<command::Stop>(page.out()));
}

}  // namespace
}  // namespace gripscan::ui
