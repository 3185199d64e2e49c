// What is kept between runs: in temporary folders, never in the user's.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/base/units.h"
#include "core/procedure/journal_codec.h"
#include "core/session/session_store.h"
#include "tests/support/synthetic_session.h"
#include "tests/support/temporary_folder.h"
#include "ui/memory/preferences_file.h"
#include "ui/memory/recent_sessions.h"
#include "ui/memory/session_line.h"

namespace gripscan::ui {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;
using End = RecentSession::End;

std::chrono::system_clock::time_point at(int seconds) {
    return std::chrono::system_clock::time_point(std::chrono::seconds(seconds));
}

std::vector<std::string> names(const std::vector<RecentSession>& lines) {
    std::vector<std::string> result;
    for (const auto& line : lines) result.push_back(line.name);
    return result;
}

TEST(RecentSessions, AreNoneBeforeTheFirst) {
    const test::TemporaryFolder folder;
    const auto lines = RecentSessions(folder / "state").list();
    ASSERT_TRUE(lines) << lines.error().message;
    EXPECT_THAT(*lines, IsEmpty());
    EXPECT_FALSE(std::filesystem::exists(folder / "state"));  // reading makes nothing
}

TEST(RecentSessions, StandLatestFirstAndEachOnce) {
    const test::TemporaryFolder folder;
    RecentSessions recent(folder / "state");
    ASSERT_TRUE(recent.add(folder / "one", at(100)));
    ASSERT_TRUE(recent.add(folder / "two", at(200)));
    ASSERT_TRUE(recent.add(folder / "one/", at(300)));  // the same folder, spelt otherwise
    const auto lines = recent.list();
    ASSERT_TRUE(lines);
    EXPECT_THAT(names(*lines), ElementsAre("one", "two"));
    EXPECT_EQ((*lines)[0].last_used, at(300));
}

TEST(RecentSessions, ForgetALineAndLeaveItsFolder) {
    const test::TemporaryFolder folder;
    RecentSessions recent(folder / "state");
    std::filesystem::create_directories(folder / "kept");
    ASSERT_TRUE(recent.add(folder / "kept", at(1)));
    ASSERT_TRUE(recent.forget(folder / "kept"));
    EXPECT_THAT(*recent.list(), IsEmpty());
    EXPECT_TRUE(std::filesystem::exists(folder / "kept"));
}

TEST(RecentSessions, KeepTheLatestOnly) {
    const test::TemporaryFolder folder;
    RecentSessions recent(folder / "state");
    for (int i = 0; i < static_cast<int>(RecentSessions::kMost) + 3; ++i) {
        ASSERT_TRUE(recent.add(folder / std::to_string(i), at(i)));
    }
    const auto lines = recent.list();
    ASSERT_THAT(*lines, SizeIs(RecentSessions::kMost));
    EXPECT_EQ(lines->back().name, "3");
}

TEST(RecentSessions, SayWhatIsWrongWithTheirFile) {
    const test::TemporaryFolder folder;
    const RecentSessions recent(folder.path());
    for (const char* text : {"", "no json", "[]", R"({"format": "gripscan-recent/9"})",
                             R"({"format": "gripscan-recent/1", "sessions": [{"folder": 3}]})"}) {
        test::write_text(folder / "recent.json", text);
        const auto lines = recent.list();
        ASSERT_FALSE(lines) << text;
        EXPECT_THAT(lines.error().message, HasSubstr("recent.json"));
    }
}

TEST(SessionLine, TellsThatAFolderIsGone) {
    const test::TemporaryFolder folder;
    const RecentSession line = session_line(folder / "monday");
    EXPECT_EQ(line.end, End::kMissing);
    EXPECT_EQ(line.name, "monday");
    EXPECT_FALSE(line.sentence.empty());
    EXPECT_EQ(session_line(folder.path()).end, End::kMissing);  // there, but no session
}

TEST(SessionLine, CountsTheStepsOfARecording) {
    const test::TemporaryFolder folder;
    test::SyntheticTurnSettings settings;
    const auto views = test::synthetic_turn(settings).size();
    test::write_synthetic_session(folder / "turn", settings);
    const RecentSession line = session_line(folder / "turn");
    EXPECT_EQ(line.kind, "gripper");
    EXPECT_EQ(line.steps_done, static_cast<int>(views) - 1);
    EXPECT_EQ(line.end, End::kComplete);
    EXPECT_THAT(line.sentence, HasSubstr("not computed"));
}

/// A rectified pair, as rig.yaml wants one.
StereoRig some_rig() {
    StereoRig rig;
    rig.image = {640, 480};
    rig.K_left << 800, 0, 320, 0, 800, 240, 0, 0, 1;
    rig.K_right = rig.K_left;
    rig.D_left = rig.D_right = {0, 0, 0, 0};
    rig.T_right_left.translation() = Eigen::Vector3d(-0.12, 0, 0);
    return rig;
}

TEST(SessionLine, OffersToGoOnWithWhatWasInterrupted) {
    const test::TemporaryFolder folder;
    TurnPlan plan;
    plan.step_rad = rad_from_deg(20.0);
    const std::array opening{JournalRecord{"cell", {{"cell", "sim"}}}, encode(plan)};
    {
        auto store =
            SessionStore::create(folder / "begun", SessionSpec{}, some_rig(), "0", opening);
        ASSERT_TRUE(store) << store.error().message;
    }
    const RecentSession line = session_line(folder / "begun");
    EXPECT_EQ(line.end, End::kInterrupted);
    EXPECT_EQ(line.cell, "SIM");
    EXPECT_EQ(line.steps_done, 0);
    EXPECT_EQ(line.steps_total, 18);
}

StoredPreferences unusual() {
    StoredPreferences stored;
    stored.preferences.theme = ThemeChoice::kLight;
    stored.preferences.user_scale = 1.75;
    stored.preferences.large_buttons = true;
    stored.preferences.navigation = "CAD";
    stored.preferences.keys = {{"step.retry", "T"}, {"view.fit", "Ctrl F"}};
    stored.splits = {300.5F, 400.0F, 250.0F};
    return stored;
}

TEST(PreferencesFile, GivesBackWhatWasSaved) {
    const test::TemporaryFolder folder;
    const auto file = folder / "deep/preferences.json";
    ASSERT_TRUE(save_preferences(file, unusual()));
    const LoadedPreferences loaded = load_preferences(file);
    EXPECT_THAT(loaded.refused, IsEmpty());
    const WindowPreferences& p = loaded.stored.preferences;
    EXPECT_EQ(p.theme, ThemeChoice::kLight);
    EXPECT_EQ(p.user_scale, 1.75);
    EXPECT_TRUE(p.large_buttons);
    EXPECT_EQ(p.navigation, "CAD");
    EXPECT_EQ(p.keys, unusual().preferences.keys);
    EXPECT_EQ(loaded.stored.splits, unusual().splits);
}

TEST(PreferencesFile, AbsentGivesTheDefaultsWithoutAWord) {
    const test::TemporaryFolder folder;
    const LoadedPreferences loaded = load_preferences(folder / "none.json");
    EXPECT_THAT(loaded.refused, IsEmpty());
    EXPECT_EQ(loaded.stored.splits, Splits{});
}

TEST(PreferencesFile, RefusesAbsurdValuesByNameAndTakesTheRest) {
    const test::TemporaryFolder folder;
    const auto file = folder / "p.json";
    for (const char* wrong :
         {R"("user_scale": 40)", R"("user_scale": -1)", R"("user_scale": "big")",
          R"("theme": "pink")", R"("large_buttons": 1)", R"("navigation": "Emacs")",
          R"("navigation": 3)", R"("keys": [1])", R"("keys": {"a": 1})", R"("keys": {"": "A"})",
          R"("stereo_width_px": 0)", R"("bottom_height_px": 1e9)", R"("colour": "blue")"}) {
        test::write_text(file, std::string(R"({"format": "gripscan-preferences/1", )") + wrong +
                                   R"(, "right_width_px": 444})");
        const LoadedPreferences loaded = load_preferences(file);
        ASSERT_THAT(loaded.refused, SizeIs(1)) << wrong;
        const std::string name = std::string(wrong).substr(1, std::string(wrong).find(':') - 2);
        EXPECT_THAT(loaded.refused[0], HasSubstr(name));
        EXPECT_EQ(loaded.stored.splits.right_width, 444.0F) << wrong;
        EXPECT_EQ(loaded.stored.preferences.user_scale, 1.0) << wrong;
        EXPECT_EQ(loaded.stored.preferences.navigation, "gripscan") << wrong;
    }
}

TEST(PreferencesFile, RefusesAFileOfAnotherVersionAsAWhole) {
    const test::TemporaryFolder folder;
    for (const char* text : {"", "{", "[]", R"({"user_scale": 2})",
                             R"({"format": "gripscan-preferences/2", "user_scale": 2})"}) {
        test::write_text(folder / "p.json", text);
        const LoadedPreferences loaded = load_preferences(folder / "p.json");
        EXPECT_THAT(loaded.refused, SizeIs(1)) << text;
        EXPECT_EQ(loaded.stored.preferences.user_scale, 1.0) << text;
    }
}

}  // namespace
}  // namespace gripscan::ui
