// The environment and the robot-camera alignment from the command line.
#include <gmock/gmock.h>

#include "core/session/alignment_file.h"
#include "tests/integration/program.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/test_data.h"
#include "tests/support/visp_poses.h"

namespace gripscan::test {
namespace {

using testing::HasSubstr;
namespace fs = std::filesystem;

TEST(RunEnvironment, LearnsThenTellsWhatHasComeAndWhatHasMoved) {
    const TemporaryFolder folder;
    const std::string room = (folder / "room").string();
    const auto learned = run_program({"run", "environment", "--cell", "sim", "--seed", "3", "--out",
                                      room, "--captures", "4", "--json"});
    ASSERT_EQ(learned.status, 0) << learned.err << learned.out;
    EXPECT_EQ(learned.json()["captures"], 4);
    EXPECT_GT(learned.json()["known"].get<double>(), 0.5);
    EXPECT_TRUE(fs::exists(folder / "room/results/environment.bin"));

    // The recording is a session like any other, and computed again it gives the same bytes.
    ASSERT_EQ(run_program({"replay", room, "--out", (folder / "again").string()}).status, 0);
    EXPECT_EQ(content_of(folder / "again"), content_of(folder / "room/results"));

    const auto look = [&](const std::vector<std::string>& faults) {
        Arguments arguments{"run", "environment", "--cell", "sim",   "--seed",
                            "3",   "--check",     room,     "--json"};
        for (const auto& fault : faults) {
            arguments.emplace_back("--fault");
            arguments.push_back(fault);
        }
        return run_program(arguments);
    };
    const auto clear = look({});
    EXPECT_EQ(clear.status, 0) << clear.err << clear.out;
    EXPECT_TRUE(clear.json()["in_the_way"].empty()) << clear.out;

    // A screwdriver of 150 mm and 26 mm across its handle.
    const auto tool = look({"tool@0"});
    EXPECT_EQ(tool.status, 1) << tool.err;
    ASSERT_FALSE(tool.json()["in_the_way"].empty()) << tool.out;
    EXPECT_NEAR(tool.json()["in_the_way"][0]["size_mm"][0].get<double>(), 140.0, 25.0);
    EXPECT_LT(tool.json()["in_the_way"][0]["size_mm"][1].get<double>(), 35.0);
    EXPECT_FALSE(tool.json()["shift"]["moved"].get<bool>());

    // A hand: 60 mm thick, 120 mm long.
    const auto hand = look({"intruder@0=60"});
    EXPECT_EQ(hand.status, 1) << hand.err;
    ASSERT_EQ(hand.json()["in_the_way"].size(), 1U) << hand.out;
    EXPECT_NEAR(hand.json()["in_the_way"][0]["size_mm"][0].get<double>(), 118.0, 15.0);

    const auto shifted = look({"shift@0=2"});
    EXPECT_EQ(shifted.status, 1) << shifted.err;
    EXPECT_TRUE(shifted.json()["shift"]["moved"].get<bool>()) << shifted.out;
    EXPECT_NEAR(shifted.json()["shift"]["length_mm"].get<double>(), 2.0, 0.3);
    EXPECT_TRUE(shifted.json()["in_the_way"].empty()) << shifted.out;
}

TEST(RunEnvironment, WrongUseIsToldBeforeAnythingIsDone) {
    const TemporaryFolder folder;
    const auto neither = run_program({"run", "environment", "--cell", "sim"});
    EXPECT_EQ(neither.status, 2);
    EXPECT_THAT(neither.err, HasSubstr("--check"));
    const auto absent =
        run_program({"run", "environment", "--check", (folder / "nothing").string()});
    EXPECT_EQ(absent.status, 2);
    EXPECT_THAT(absent.err, HasSubstr("nothing"));
}

TEST(CalibrateRobot, ReadsRealPhotographsAndWritesWhatTheOthersRead) {
    GRIPSCAN_TEST_DATA(data, "visp-eye-in-hand");
    const TemporaryFolder folder;
    write_visp_poses(data, folder / "poses.yaml");
    const std::string out = (folder / "alignment.yaml").string();
    const auto result = run_program({"calibrate", "robot", "--poses",
                                     (folder / "poses.yaml").string(), "--out", out, "--json"});
    ASSERT_EQ(result.status, 0) << result.err << result.out;
    EXPECT_EQ(result.json()["views"], 8);
    const auto file = load_alignment(out);
    ASSERT_TRUE(file) << file.error().message;
    ASSERT_TRUE(file->T_flange_camera);
    EXPECT_LT((file->T_flange_camera->translation() - visp_reference(data).translation()).norm(),
              0.003);
}

}  // namespace
}  // namespace gripscan::test
