// What the window says in the states of a turn.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include <algorithm>

#include "core/base/units.h"
#include "tests/support/sample_snapshot.h"
#include "ui/views/log_text.h"
#include "ui/views/row_commands.h"
#include "ui/views/sentences.h"
#include "ui/views/stages.h"
#include "ui/views/status_text.h"
#include "ui/views/step_text.h"
#include "ui/views/table_text.h"

namespace gripscan::ui {
namespace {

using namespace gripscan::test;
using testing::ElementsAre;
using testing::HasSubstr;

std::vector<State> states_of(const Sample& sample) {
    std::vector<State> states;
    for (const StageText& stage : stages_of(sample.snapshot)) states.push_back(stage.state);
    return states;
}
std::string_view current_of(const Sample& sample) {
    for (const StageText& stage : stages_of(sample.snapshot)) {
        if (stage.current) return stage.id;
    }
    return {};
}

TEST(Stages, TellWhereTheTurnStands) {
    using enum State;
    EXPECT_THAT(states_of(sample_empty()),
                ElementsAre(kWaiting, kWaiting, kWaiting, kWaiting, kWaiting, kWaiting, kWaiting));
    EXPECT_EQ(current_of(sample_empty()), "stage.connect");
    EXPECT_THAT(states_of(sample_cell_checked()),
                ElementsAre(kAccept, kCheck, kWaiting, kWaiting, kWaiting, kWaiting, kWaiting));
    EXPECT_EQ(current_of(sample_cell_checked()), "stage.warm_up");
    EXPECT_THAT(states_of(sample_running()),
                ElementsAre(kAccept, kCheck, kWaiting, kAccept, kRunning, kWaiting, kWaiting));
    EXPECT_THAT(states_of(sample_rejected()),
                ElementsAre(kAccept, kCheck, kWaiting, kAccept, kReject, kWaiting, kWaiting));
    EXPECT_EQ(current_of(sample_rejected()), "stage.gripper");
    EXPECT_THAT(states_of(sample_finished()),
                ElementsAre(kAccept, kCheck, kWaiting, kAccept, kCheck, kWaiting, kAccept));
    EXPECT_EQ(current_of(sample_finished()), "stage.export");
}

TEST(Stages, ShowTheirCriterionAsANumber) {
    const auto stages = stages_of(sample_running().snapshot);
    EXPECT_EQ(stages[0].criterion, "link 3 ms ≤ 500 ms");
    EXPECT_EQ(stages[1].criterion, "10 of 11 in their limits, volume");
    EXPECT_EQ(stages[3].criterion, "axis sd 0.04°, 0.11 mm");
    EXPECT_EQ(stages[4].criterion, "step 14 of 36, 140.0°");
    EXPECT_EQ(stages_of(sample_finished().snapshot)[4].criterion, "closure 0.21°, 0.42 mm");
}

TEST(Stages, TellOfEnvironmentObjectAndRecognition) {
    Sample sample = sample_running();
    EXPECT_EQ(stages_of(sample.snapshot)[4].name, "Gripper");
    sample.snapshot.session->object = true;
    sample.snapshot.environment = EnvironmentFacts{"/data/environment", 8, 0.996};
    sample.snapshot.library = {{"gripper", TemplateKind::kGripper, 1000, "none", "", ""}};
    const auto stages = stages_of(sample.snapshot);
    EXPECT_EQ(stages[2].state, State::kAccept);
    EXPECT_EQ(stages[2].criterion, "8 views, 0.4 % unknown");
    EXPECT_EQ(stages[4].name, "Object");
    EXPECT_EQ(stages[5].criterion, "1 templates");
}

TEST(Stages, LeaveOutTheWarmUpWhereTheOperatorTurns) {
    Sample sample = sample_cell_checked();
    set_mode(sample, MotionMode::kManual);
    EXPECT_EQ(stages_of(sample.snapshot).size(), 6U);
    EXPECT_EQ(current_of(sample), "stage.gripper");
}

TEST(Stages, NameTheItemThatFailed) {
    Sample sample = sample_cell_checked();
    sample.state->cell->items[6].outcome = CheckOutcome::kFailed;
    const StageText stage = stages_of(sample.snapshot)[1];
    EXPECT_EQ(stage.state, State::kReject);
    EXPECT_EQ(stage.criterion, "exposure failed");
    EXPECT_EQ(current_of(sample), "stage.cell");
    sample.state->cell_note = "the white spot is a screw";
    EXPECT_EQ(stages_of(sample.snapshot)[1].state, State::kCheck);
}

TEST(Verdict, IsOneSentenceWithValueLimitAndReason) {
    const VerdictWords accepted = verdict_of(sample_running().snapshot);
    EXPECT_EQ(accepted.state, State::kAccept);
    EXPECT_EQ(accepted.sentence,
              "ICP turned `9.977°`, the robot `9.998°`: error `−0.021°` is inside the limit of "
              "`±0.100°`.");
    const VerdictWords rejected = verdict_of(sample_rejected().snapshot);
    EXPECT_EQ(rejected.state, State::kReject);
    EXPECT_EQ(rejected.sentence,
              "ICP turned `24.299°`, the robot `10.001°`: error `+14.298°`, limit `±0.100°`.");
    EXPECT_EQ(cause_of(sample_rejected().snapshot)->cause,
              "The two views share too little surface");
    EXPECT_FALSE(cause_of(sample_running().snapshot));
}

TEST(Verdict, BelongsToTheSelectedRow) {
    Sample sample = sample_running();
    sample.snapshot.follows_last = false;
    sample.snapshot.selected_row = 10;
    EXPECT_EQ(verdict_of(sample.snapshot).state, State::kCheck);
    EXPECT_EQ(heading_of(sample.snapshot).title, "Step 11");
    ASSERT_TRUE(cause_of(sample.snapshot));
    sample.snapshot.selected_row = 1000;
    EXPECT_EQ(heading_of(sample.snapshot).title, "Step 14");
}

TEST(Verdict, SaysWhatIsGoingOnAndWhatIsWaitedFor) {
    EXPECT_EQ(verdict_of(sample_aligning().snapshot).word, "Aligning");
    EXPECT_EQ(verdict_of(sample_empty().snapshot).word, "Not connected");
    EXPECT_EQ(verdict_of(sample_cell_checked().snapshot).word, "Cell is ready");
    const VerdictWords lost = verdict_of(sample_link_lost().snapshot);
    EXPECT_EQ(lost.word, "Interrupted");
    EXPECT_THAT(lost.sentence, HasSubstr("no answer"));
    Sample offline = sample_empty();
    offline.state->phase = phase::Offline{"nobody answers at 10.0.0.5", std::nullopt};
    EXPECT_EQ(verdict_of(offline.snapshot).state, State::kReject);
}

TEST(Evidence, IsSortedWorstFirstForARejectedStepOnly) {
    const auto rejected = evidence_rows(sample_rejected().snapshot);
    ASSERT_EQ(rejected.size(), 7U);
    EXPECT_EQ(rejected[0].id, "evidence.angle_error");
    EXPECT_EQ(rejected[1].id, "evidence.axis_tilt");
    for (std::size_t i = 1; i < rejected.size(); ++i) {
        EXPECT_GE(rejected[i - 1].excess, rejected[i].excess);
    }
    const auto accepted = evidence_rows(sample_running().snapshot);
    EXPECT_EQ(accepted[0].id, "evidence.angle_error");
    EXPECT_EQ(accepted[3].id, "evidence.slip");
    for (const EvidenceText& e : accepted) EXPECT_LE(e.excess, 1.0) << e.id;
    const auto ahead = evidence_rows(sample_empty().snapshot);
    ASSERT_EQ(ahead.size(), 4U) << "the limits that the plan sets";
    for (const EvidenceText& e : ahead) {
        EXPECT_TRUE(std::isnan(e.value)) << e.id;
        EXPECT_EQ(e.state, State::kWaiting) << e.id;
    }
}

TEST(Heading, AddsUpWhatTheTableHolds) {
    const StepHeading heading = heading_of(sample_running().snapshot);
    EXPECT_EQ(heading.title, "Step 14");
    EXPECT_EQ(heading.of, "of 36");
    ASSERT_EQ(heading.lines.size(), 4U);
    EXPECT_EQ(heading.lines[0].value, "140.001°");
    EXPECT_EQ(heading.lines[3].value, "5 min 12 s");
}

TEST(Dial, CountsARefusedStepAsNotTurned) {
    const DialText dial = dial_of(sample_rejected().snapshot);
    EXPECT_NEAR(dial.turned_deg, 50.0, 1e-9);
    EXPECT_NEAR(dial.refused_deg, 10.0, 1e-9);
    EXPECT_EQ(dial.next_deg, 0.0);
    EXPECT_NEAR(dial.robot_deg, 60.0, 0.02) << "readings of six steps";
    const DialText running = dial_of(sample_running().snapshot);
    EXPECT_NEAR(running.turned_deg, 140.0, 1e-9);
    EXPECT_NEAR(running.next_deg, 10.0, 1e-9);
    const DialText aligning = dial_of(sample_aligning().snapshot);
    EXPECT_NEAR(aligning.turned_deg, 140.0, 1e-9) << "a view that is not compared counts not yet";
}

TEST(StepsPlanned, CountTheHalvesThatWereTaken) {
    Sample sample = sample_running();
    EXPECT_EQ(steps_planned(*sample.state), 36);
    sample.state->data.step_rad *= 0.5;
    EXPECT_EQ(steps_planned(*sample.state), 14 + 44);
}

TEST(StepWaits, SaysWhy) {
    EXPECT_EQ(why_step_waits(sample_running().snapshot), "");
    EXPECT_EQ(why_step_waits(sample_rejected().snapshot),
              "Step 6 is to be accepted or taken again.");
    EXPECT_EQ(why_step_waits(sample_aligning().snapshot),
              "Step waits: something is going on: stop it or wait.");
}

TEST(Table, ShowsTheNumbersOfTable1Rounded) {
    const Sample sample = sample_running();
    const TableText table = table_text(sample.snapshot, TableView::kRobotAgainstIcp);
    ASSERT_EQ(table.rows.size(), 14U);
    std::vector<std::string> texts;
    for (const CellText& cell : table.rows[13].cells) texts.push_back(cell.text);
    EXPECT_THAT(texts,
                ElementsAre("14", "1", "10.00", "9.998", "9.977", "−0.021", "0.7", "0.056", "0.09",
                            "+0.09", "88", "0.21", "0.38", "0.62", "Free", "Accept", "140.12"));
    EXPECT_EQ(table.rows[10].cells[15].shape, State::kCheck);
    ASSERT_EQ(table.last_rows.size(), 2U);
    EXPECT_EQ(table.last_rows[0].cells[3].text, "140.001");
    EXPECT_EQ(table.last_rows[0].cells[15].text, "14 of 36, 220.00° to go");
    EXPECT_THAT(table.last_rows[1].cells[15].text, HasSubstr("expected ±0.18° at 360°"));
}

TEST(Table, MarksARejectedRowAndWhatWaitsForIt) {
    const TableText table = table_text(sample_rejected().snapshot, TableView::kRobotAgainstIcp);
    ASSERT_EQ(table.rows.size(), 7U);
    EXPECT_EQ(table.rows[5].tint, State::kReject);
    EXPECT_EQ(table.rows[5].cells[5].bar, 1.0);
    EXPECT_EQ(table.rows[5].cells[7].emphasis, Emphasis::kReject);
    EXPECT_EQ(table.rows[6].cells[15].text, "waits for step 6");
    // Nothing of it is in the sum while it is not decided: five steps of 10°.
    EXPECT_EQ(table.last_rows[0].cells[2].text, "50.00");
    EXPECT_EQ(table.last_rows[0].cells[15].text, "5 of 36, 310.00° to go");
    const TableText aligning = table_text(sample_aligning().snapshot, TableView::kRobotAgainstIcp);
    EXPECT_EQ(aligning.rows.back().cells[15].shape, State::kRunning);
}

TEST(Table, HasTheColumnsOfThePaperOneSwitchAway) {
    const TableText table = table_text(sample_running().snapshot, TableView::kPose);
    std::vector<std::string_view> titles;
    for (const ColumnText& column : table.columns) titles.push_back(column.title);
    for (const char* title : {"roll", "pitch", "yaw", "X", "Y", "Z"}) {
        EXPECT_THAT(titles, testing::Contains(title));
    }
    for (const RowText& row : table.rows) EXPECT_EQ(row.cells.size(), table.columns.size());
}

TEST(Table, ClosureStandsThereOnceItIsKnown) {
    const TableText table = table_text(sample_finished().snapshot, TableView::kRobotAgainstIcp);
    EXPECT_EQ(table.last_rows[1].cells[5].text, "+0.210");
    EXPECT_EQ(table.last_rows[1].cells[15].text, "solved together 0.03°, 0.08 mm");
}

TEST(Clipboard, HoldsTheNumbersOfTheCsv) {
    const Sample sample = sample_running();
    std::string csv = table1_csv(full_table(sample.snapshot));
    std::string copied = table_for_clipboard(sample.snapshot);
    // No cell of these rows holds a comma, so that only the separators differ.
    const auto line = [](const std::string& text, int number) {
        std::size_t from = 0;
        for (int i = 0; i < number; ++i) from = text.find('\n', from) + 1;
        std::string one = text.substr(from, text.find('\n', from) - from);
        std::replace(one.begin(), one.end(), '\t', ',');
        std::erase(one, '\r');
        return one;
    };
    EXPECT_EQ(line(copied, 0), line(csv, 0));
    EXPECT_EQ(line(copied, 14), line(csv, 14));
    EXPECT_THAT(line(copied, 14), HasSubstr("9.977"));
}

TEST(Attempts, ListSupersededCapturesToo) {
    Sample sample = sample_rejected();
    sample.state->data.captures[6].status = CaptureStatus::kSuperseded;
    const TableText attempts = attempts_text(sample.snapshot);
    ASSERT_EQ(attempts.rows.size(), 7U);
    EXPECT_EQ(attempts.rows[6].cells[7].text, "superseded");
    EXPECT_EQ(attempts.rows[6].cells[9].shape, State::kReject) << "its verdict is not forgotten";
    for (const RowText& row : attempts.rows) EXPECT_EQ(row.cells.size(), attempts.columns.size());
}

TEST(RowCommands, OfTheLastRowCanAllBeGiven) {
    const Sample sample = sample_rejected();
    const auto last = row_commands(sample.snapshot, 5);
    ASSERT_EQ(last.size(), 3U);
    for (const RowCommand& command : last) EXPECT_FALSE(command.why_not) << command.id;
    EXPECT_EQ(std::get<command::Retake>(std::get<request::Give>(last[0].request).command).index, 6);
    EXPECT_EQ(row_commands(sample.snapshot, 2)[2].why_not, "only the last step can be accepted");
    EXPECT_TRUE(row_commands(sample.snapshot, 6).empty());
    EXPECT_EQ(row_commands(sample_aligning().snapshot, 0)[0].why_not,
              "something is going on: stop it or wait");
}

TEST(Log, IsFilteredByLevelAndWords) {
    const Sample sample = sample_rejected();
    const auto& log = *sample.log;
    EXPECT_EQ(filtered(log, {}).size(), log.size());
    EXPECT_EQ(filtered(log, {LogLevel::kWarning, {}}).size(), 4U);
    EXPECT_EQ(filtered(log, {LogLevel::kError, {}}).size(), 1U);
    EXPECT_EQ(filtered(log, {LogLevel::kInformation, "reg-012"}).size(), 1U);
    EXPECT_EQ(filtered(log, {LogLevel::kInformation, "FILL"}).size(), 2U);
    EXPECT_TRUE(filtered(log, {LogLevel::kError, "fill"}).empty());
    EXPECT_EQ(worst_of(log), LogLevel::kError);
    EXPECT_EQ(log_for_clipboard(log, {LogLevel::kError, {}}),
              "14:31:09\terror\tREG-012\tStep 6: ICP 24.299° against 10.001°\n");
}

TEST(Status, TellsRobotJointsAndWhatHasToBeLookedAt) {
    const StatusText running = status_of(sample_running().snapshot);
    EXPECT_EQ(running.robot, "Ready");
    EXPECT_EQ(running.joint6, "−39.999°");
    EXPECT_EQ(running.other_joints, "J1–J5 still");
    EXPECT_EQ(running.checks, 1);
    EXPECT_EQ(running.rejected, 0);
    EXPECT_EQ(status_of(sample_rejected().snapshot).rejected, 1);
    EXPECT_EQ(status_of(sample_aligning().snapshot).robot, "Aligning");
    EXPECT_EQ(status_of(sample_link_lost().snapshot).robot_state, State::kCheck);
    Sample moved = sample_running();
    moved.state->reading->joints_rad[1] += rad_from_deg(0.31);
    EXPECT_EQ(status_of(moved.snapshot).other_joints, "J2 moved 0.31°");
    EXPECT_TRUE(status_of(moved.snapshot).others_moved);
}

TEST(Durations, AreRoundedDown) {
    EXPECT_EQ(duration_text(4.9), "4 s");
    EXPECT_EQ(duration_text(312.0), "5 min 12 s");
    EXPECT_EQ(duration_text(7509.0), "2 h 05 min");
    EXPECT_EQ(duration_text(std::numeric_limits<double>::infinity()), "–");
}

TEST(Sentences, MarkNumbersAndUseTheUnitsOfTheScreen) {
    EXPECT_EQ(shown_sentence("error -0.021 deg, limit 0.100 deg"),
              "Error `−0.021°`, limit `0.100°`.");
    EXPECT_EQ(shown_sentence("overlap 41 %, limit 60 %: too large"),
              "Overlap `41 %`, limit `60 %`: too large.");
    EXPECT_EQ(shown_sentence("joints 1 … 5 of J6 stand"), "Joints `1` … `5` of J6 stand.");
    EXPECT_EQ(shown_sentence("192.168.1.10:16001: no answer"), "192.168.1.10:`16001`: no answer.");
    EXPECT_EQ(shown_sentence(""), "");
}

}  // namespace
}  // namespace gripscan::ui
