#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/session/journal_file.h"
#include "core/session/session.h"
#include "tests/integration/program.h"
#include "tests/support/temporary_folder.h"

namespace gripscan::test {
namespace {

using testing::HasSubstr;
namespace fs = std::filesystem;

/// Steps of 20° keep the test short: 19 captures, and still more than half of each view is shared.
TEST(RunGripper, RecordsAndComputesAWholeTurnInTheSimulatedCell) {
    const TemporaryFolder folder;
    const fs::path session = folder / "montag";
    const auto result =
        run_program({"run", "gripper", "--cell", "sim", "--out", session.string(), "--step-deg",
                     "20", "--seed", "5", "--truth", (folder / "truth").string(), "--json"});
    ASSERT_EQ(result.status, 0) << result.err << result.out;
    const auto json = result.json();
    ASSERT_EQ(json["steps"].size(), 18u);
    for (const auto& step : json["steps"]) {
        EXPECT_NEAR(step["error_deg"].get<double>(), 0.0, 0.5) << step["index"];
        EXPECT_EQ(step["verdict"], "accept") << step["sentence"];
    }
    EXPECT_EQ(json["sign_source"], "axis_hint");
    EXPECT_LT(json["closure"]["after"]["mm"].get<double>(), 1.0);
    EXPECT_TRUE(fs::exists(folder / "truth/truth.json"));

    // What the run computed is what a replay of its recording computes.
    ASSERT_EQ(
        run_program({"replay", session.string(), "--out", (folder / "again").string()}).status, 0);
    EXPECT_EQ(content_of(folder / "again"), content_of(session / "results"));

    const auto journal = read_journal(session / "journal");
    ASSERT_TRUE(journal) << journal.error().message;
    EXPECT_EQ(journal->entries.front().event, "cell");
    const auto solved = std::count_if(
        journal->entries.begin(), journal->entries.end(), [](const JournalEntry& entry) {
            return entry.event == "event" && entry.fields.front().second == "solved";
        });
    EXPECT_EQ(solved, 1);

    // A second run into the same folder must not touch the recording.
    const auto before = content_of(session);
    const auto second = run_program({"run", "gripper", "--out", session.string()});
    EXPECT_EQ(second.status, 2);
    EXPECT_THAT(second.err, HasSubstr("never overwritten"));
    EXPECT_EQ(content_of(session), before);
}

double turned_deg(const nlohmann::json& pose) {
    const auto at = [&](std::size_t i) { return pose[i].get<double>(); };
    const double cosine = 0.5 * (at(0) + at(5) + at(10) - 1.0);
    return std::acos(std::clamp(cosine, -1.0, 1.0)) * 180.0 / std::numbers::pi;
}

/// Nothing of a cylinder shows its turn: it is said, the rest is completed with the robot's angles
/// about the axis of the surface, and no row claims to be a measurement.
TEST(RunGripper, ASymmetricGripperIsCompletedByAxisAndRobot) {
    const TemporaryFolder folder;
    const auto result =
        run_program({"run", "gripper", "--cell", "sim", "--gripper-model", "cylinder", "--step-deg",
                     "30", "--seed", "2", "--out", (folder / "s").string(), "--json"});
    EXPECT_EQ(result.status, 1) << result.err;
    EXPECT_THAT(result.err, HasSubstr("looks the same all around the axis"));
    EXPECT_THAT(result.err, HasSubstr("cause=symmetry action=lock the axis"));
    const auto json = result.json();
    ASSERT_EQ(json["steps"].size(), 12u);
    for (const auto& step : json["steps"]) {
        EXPECT_EQ(step["mode"], "axis-locked");
        EXPECT_EQ(step["independent"], false);
        EXPECT_EQ(step["verdict"], "check") << step["sentence"];
        EXPECT_EQ(step["cause"], "symmetry");
    }
    EXPECT_TRUE(json["closure"].is_null()) << "the robot's word is no closure";
    EXPECT_GT(json["template"]["points"].get<int>(), 10000);
    double expected_deg = 0.0;
    for (const auto& pose : json["poses"]) {
        if (pose.is_null()) continue;  // taken before the lock
        const double short_way_deg = std::min(expected_deg, 360.0 - expected_deg);
        EXPECT_NEAR(turned_deg(pose), short_way_deg, 0.1);
        expected_deg += 30.0;
    }
    EXPECT_EQ(expected_deg, 390.0) << "thirteen views";
}

TEST(RunGripper, StopsCleanlyOnCtrlCAndKeepsWhatItRecorded) {
    const TemporaryFolder folder;
    const fs::path session = folder / "s";
    const auto result = interrupt_program({"run", "gripper", "--out", session.string()}, [&] {
        return fs::exists(session / "frames/002_right.png");
    });
    EXPECT_EQ(result.status, 4) << result.err;
    EXPECT_FALSE(fs::exists(session / "results"));
    const auto kept = open_session(session);
    ASSERT_TRUE(kept) << kept.error().message;
    EXPECT_GE(kept->table.rows.size(), 2u);
    EXPECT_TRUE(check_session_files(*kept, {}, for_each_in_order));
    for (const auto& [name, content] : content_of(session)) {
        EXPECT_THAT(name, testing::Not(HasSubstr(".part"))) << "a half-written file";
    }
}

TEST(RunGripper, WhatIsMissingInACellFileIsNamed) {
    const TemporaryFolder folder;
    write_text(folder / "cell.yaml",
               "format: gripscan-cell/1\nrobot: {dialect: gsp1, host: 127.0.0.1}\n");
    const auto cell = [&](const std::string& file) {
        return run_program({"run", "gripper", "--cell", (folder / file).string(), "--out",
                            (folder / "s").string()});
    };
    const auto blind = cell("cell.yaml");
    EXPECT_EQ(blind.status, 2);
    EXPECT_THAT(blind.err, HasSubstr("names no camera"));
    EXPECT_EQ(cell("nowhere.yaml").status, 2);
    replace_in_file(folder / "cell.yaml", "robot:", "robots:");
    const auto misspelt = cell("cell.yaml");
    EXPECT_EQ(misspelt.status, 2);
    EXPECT_THAT(misspelt.err, HasSubstr("cell.yaml:2"));
    EXPECT_FALSE(fs::exists(folder / "s"));
}

TEST(RunGripper, WritesTheTruthApart) {
    const TemporaryFolder folder;
    const auto result = run_program({"run", "gripper", "--out", (folder / "s").string(), "--truth",
                                     (folder / "s/truth").string()});
    EXPECT_EQ(result.status, 2);
    EXPECT_THAT(result.err, HasSubstr("apart"));
    EXPECT_FALSE(fs::exists(folder / "s"));
}

}  // namespace
}  // namespace gripscan::test
