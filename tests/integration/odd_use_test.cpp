#include <gmock/gmock.h>
#include <sys/wait.h>

#include <cstdlib>

#include "core/camera/image_file.h"
#include "core/stereo/rig_file.h"
#include "tests/integration/program.h"
#include "tests/support/synthetic_session.h"

namespace gripscan::test {
namespace {

using testing::HasSubstr;
namespace fs = std::filesystem;

/// Uses that are odd, but happen: each either works or says why it does not.
class OddUse : public testing::Test {
  protected:
    void SetUp() override {
        SyntheticTurnSettings settings;
        settings.captures = 3;
        settings.samples = 6000;
        ASSERT_NO_FATAL_FAILURE(write_synthetic_session(session_, settings));
    }

    /// Exit status of the shell's command line; PROGRAM stands for the program.
    int shell(const std::string& where, std::string line) {
        line.replace(line.find("PROGRAM"), 7, GRIPSCAN_PROGRAM);
        const std::string all =
            fmt::format("cd '{}' && {} 2>'{}'", where, line, (folder_ / "err").string());
        return WEXITSTATUS(std::system(all.c_str()));
    }

    TemporaryFolder folder_;
    fs::path session_ = folder_ / "session";
};

TEST_F(OddUse, ResultThatCannotBePrintedIsNoSuccess) {
    const std::string here = folder_.path().string();
    EXPECT_EQ(shell(here, "PROGRAM replay session --out out --json >/dev/full"), 2);
    EXPECT_THAT(read_text(folder_ / "err"), HasSubstr("standard output"));
    EXPECT_EQ(shell(here, "PROGRAM replay session --out out >/dev/full"), 2);
    EXPECT_EQ(shell(here, "PROGRAM replay session --out out --json >/dev/null"), 0);
}

TEST_F(OddUse, AStandardErrorThatCannotBeWrittenIsNoEnd) {
    const std::string here = folder_.path().string();
    EXPECT_EQ(shell(here, "{ PROGRAM run gripper --cell nosuch --out u 2>/dev/full; }"), 2);
    EXPECT_EQ(shell(here, "{ PROGRAM replay session --out out 2>&-; }"), 0);
}

TEST_F(OddUse, CurrentFolderIsNotReplaced) {
    fs::create_directories(folder_ / "here");
    EXPECT_EQ(shell((folder_ / "here").string(), "PROGRAM replay ../session --out ."), 2);
    EXPECT_THAT(read_text(folder_ / "err"), HasSubstr("current"));
    EXPECT_EQ(shell((folder_ / "here").string(), "PROGRAM replay ../session --out in --quiet"), 0);
}

TEST_F(OddUse, LinkKeepsLeadingToItsFolder) {
    fs::create_directories(folder_ / "real");
    fs::create_directory_symlink(folder_ / "real", folder_ / "link");
    EXPECT_EQ(
        run_program({"replay", session_.string(), "--out", (folder_ / "link").string()}).status, 0);
    EXPECT_TRUE(fs::is_symlink(folder_ / "link"));
    EXPECT_TRUE(fs::exists(folder_ / "real/turns.json"));
    fs::create_directory_symlink(folder_ / "nowhere", folder_ / "dangling");
    const auto result =
        run_program({"replay", session_.string(), "--out", (folder_ / "dangling").string()});
    EXPECT_EQ(result.status, 2);
    EXPECT_THAT(result.err, HasSubstr("leads nowhere"));
}

TEST_F(OddUse, ResultsOfOtherCapturesAreNotPassedOn) {
    ASSERT_EQ(run_program({"replay", session_.string()}).status, 0);
    const std::string out = (folder_ / "part.ply").string();
    EXPECT_EQ(run_program({"export", session_.string(), "--out", out}).status, 0);
    fs::remove(out);
    std::string table = read_text(session_ / "captures.csv");
    table.insert(table.find('\n'), ",status");
    for (const std::string row : {"000.pcd", "002.pcd"}) table.insert(table.find(row) + 7, ",used");
    table.insert(table.find("001.pcd") + 7, ",excluded");
    write_text(session_ / "captures.csv", table);
    for (const std::string command : {"export", "report"}) {
        const auto result = run_program({command, session_.string(), "--out", out});
        EXPECT_EQ(result.status, 2) << command;
        EXPECT_THAT(result.err, HasSubstr("gripscan replay"));
    }
    EXPECT_FALSE(fs::exists(out));
    EXPECT_EQ(run_program({"replay", session_.string()}).status, 0);
    EXPECT_EQ(run_program({"export", session_.string(), "--out", out}).status, 0);
}

TEST_F(OddUse, NumbersThatAreNone) {
    const std::string cloud = (session_ / "clouds/000.pcd").string();
    const auto refused = [](Arguments arguments, const std::string& option,
                            const std::string& value) {
        arguments.insert(arguments.end(), {option, value});
        const auto result = run_program(arguments);
        EXPECT_EQ(result.status, 2) << option << ' ' << value;
        EXPECT_EQ(result.out, "");
        EXPECT_THAT(result.err, HasSubstr(option));
    };
    for (const std::string option :
         {"--rotation-deg", "--icp-max-correspondence-mm", "--icp-voxel-mm"}) {
        for (const std::string value : {"nan", "inf", "ten"}) {
            refused({"align", cloud, cloud, "--method", "paper-icp"}, option, value);
        }
    }
    refused({"align", cloud, cloud}, "--seed", "-1");
    const std::string out = (folder_ / "run").string();
    refused({"run", "gripper", "--out", out}, "--step-deg", "nan");
    refused({"run", "gripper", "--out", out}, "--seed", "-1");
    refused({"run", "gripper", "--out", out}, "--seed", "99999999999999999999999");
    EXPECT_FALSE(fs::exists(folder_ / "run"));
}

TEST_F(OddUse, StereoWithoutAPointIsNotDone) {
    StereoRig rig;
    rig.image = {160, 120};
    rig.K_left << 150, 0, 79.5, 0, 150, 59.5, 0, 0, 1;
    rig.K_right = rig.K_left;
    rig.T_right_left.translation().x() = -0.1;
    ASSERT_TRUE(save_rig(folder_ / "rig.yaml", rig));
    const std::string image = (folder_ / "grey.png").string();
    ASSERT_TRUE(save_png(image, cv::Mat(120, 160, CV_8UC1, cv::Scalar(100))));
    const auto result =
        run_program({"stereo", image, image, "--rig", (folder_ / "rig.yaml").string(), "--out",
                     (folder_ / "cloud.pcd").string(), "--json"});
    EXPECT_EQ(result.status, 1) << result.err;
    EXPECT_EQ(result.json()["cloud"]["points"], 0);
    EXPECT_THAT(result.err, HasSubstr("no point"));
}

}  // namespace
}  // namespace gripscan::test
