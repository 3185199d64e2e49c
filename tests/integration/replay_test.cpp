#include <gmock/gmock.h>

#include <cmath>
#include <set>

#include "tests/integration/program.h"
#include "tests/support/synthetic_session.h"

namespace gripscan::test {
namespace {

using testing::HasSubstr;
using testing::Not;
namespace fs = std::filesystem;

class Replay : public testing::Test {
  protected:
    void SetUp() override { ASSERT_NO_FATAL_FAILURE(write_synthetic_session(session_)); }

    ProgramResult replay(const std::string& out, Arguments more = {},
                         const Environment& environment = {}) {
        Arguments arguments{"replay", session_.string(), "--out", (folder_ / out).string()};
        arguments.insert(arguments.end(), more.begin(), more.end());
        return run_program(arguments, environment);
    }

    TemporaryFolder folder_;
    fs::path session_ = folder_ / "sitzung eins";
};

TEST_F(Replay, WritesExactlyTheResultsAndLeavesTheSessionAlone) {
    const auto before = content_of(session_);
    const auto result = replay("out", {"--json"});
    EXPECT_EQ(result.status, 0) << result.err;
    EXPECT_EQ(content_of(session_), before);
    std::set<std::string> names;
    for (const auto& [name, content] : content_of(folder_ / "out")) names.insert(name);
    EXPECT_EQ(names, (std::set<std::string>{"turns.csv", "turns.json", "template.pcd",
                                            "template.json", "report.html"}));
}

TEST_F(Replay, PrintsTheSameDocumentAsItWritesButForThePath) {
    const auto result = replay("out", {"--json"});
    auto printed = result.json();
    ASSERT_TRUE(printed.is_object()) << result.out;
    EXPECT_EQ(printed["template"]["path"], (folder_ / "out/template.pcd").string());
    auto written = nlohmann::json::parse(read_text(folder_ / "out/turns.json"));
    EXPECT_EQ(written["template"]["path"], "template.pcd");
    written["template"]["path"] = printed["template"]["path"];
    EXPECT_EQ(printed, written);
    EXPECT_EQ(result.err, "") << "no progress where nobody looks";
}

TEST_F(Replay, FindsTheTurn) {
    const auto json = replay("out", {"--json"}).json();
    ASSERT_EQ(json["steps"].size(), 5u);
    for (const auto& step : json["steps"]) {
        // 0.2 mm of noise over some 6000 points: hundredths of a degree.
        EXPECT_NEAR(step["icp_deg"].get<double>(), 10.0, 0.15);
        EXPECT_EQ(step["verdict"], "accept") << step["sentence"];
    }
    EXPECT_EQ(json["sign_source"], "joint");
    EXPECT_EQ(json["poses"].size(), 6u);
    EXPECT_GT(json["template"]["points"].get<int>(), 1000);
}

TEST_F(Replay, GivesTheSameBytesOnEveryRunAndWithAnyNumberOfThreads) {
    ASSERT_EQ(replay("one", {"--threads", "1"}).status, 0);
    ASSERT_EQ(replay("two", {"--threads", "2"}).status, 0);
    ASSERT_EQ(replay("env", {}, {"GRIPSCAN_THREADS=3"}).status, 0);
    const auto one = content_of(folder_ / "one");
    EXPECT_EQ(content_of(folder_ / "two"), one);
    EXPECT_EQ(content_of(folder_ / "env"), one);
}

TEST_F(Replay, WritesNumbersWithAPointInEveryLocale) {
    ASSERT_EQ(replay("plain").status, 0);
    const auto locales = folder_ / "locales";
    fs::create_directories(locales);
    const std::string make =
        "localedef -i de_DE -f UTF-8 '" + (locales / "de_DE.UTF-8").string() + "' 2>/dev/null";
    if (std::system(make.c_str()) != 0) GTEST_SKIP() << "cannot make a German locale: localedef";
    const auto german = replay("german", {}, {"LC_ALL=de_DE.UTF-8", "LOCPATH=" + locales.string()});
    ASSERT_EQ(german.status, 0) << german.err;
    EXPECT_EQ(content_of(folder_ / "german"), content_of(folder_ / "plain"));
}

TEST_F(Replay, PrintsTheTableForPeopleAndNothingWhenQuiet) {
    const auto loud = replay("out");
    EXPECT_THAT(loud.out, HasSubstr("5 of 5 steps accepted"));
    EXPECT_THAT(loud.out, HasSubstr("template.pcd"));
    const auto quiet = replay("out", {"--quiet"});
    EXPECT_EQ(quiet.status, 0);
    EXPECT_EQ(quiet.out + quiet.err, "");
}

TEST_F(Replay, DefaultsToTheResultsOfTheSession) {
    ASSERT_EQ(run_program({"replay", session_.string()}).status, 0);
    EXPECT_TRUE(fs::exists(session_ / "results/turns.json"));
    ASSERT_EQ(run_program({"replay", session_.string() + "/"}).status, 0) << "a second time";
}

TEST_F(Replay, TakesASymbolicLinkAndARelativePath) {
    fs::create_symlink(session_, folder_ / "link");
    EXPECT_EQ(
        run_program({"replay", (folder_ / "link").string(), "--out", (folder_ / "out").string()})
            .status,
        0);
}

TEST_F(Replay, RepeatsThePapersMethod) {
    const auto json = replay("paper", {"--json", "--method", "paper-icp", "--icp-iterations", "5",
                                       "--icp-max-correspondence-mm", "20"})
                          .json();
    ASSERT_EQ(json["steps"].size(), 5u);
    EXPECT_TRUE(json["steps"][0]["icp_deg"].is_number());
    const auto ours = replay("ours", {"--json"}).json();
    const auto error = [](const nlohmann::json& turns) {
        double sum = 0.0;
        for (const auto& step : turns["steps"]) sum += std::abs(step["error_deg"].get<double>());
        return sum;
    };
    EXPECT_GT(error(json), 3.0 * error(ours));
}

TEST_F(Replay, AGapInTheIndicesIsOneLargerStep) {
    replace_in_file(session_ / "captures.csv", "2,20,-70,,,clouds/002.pcd\n", "");
    const auto result = replay("out", {"--json"});
    EXPECT_EQ(result.status, 0) << result.out;
    const auto json = result.json();
    EXPECT_EQ(json["steps"][1]["from"], 1);
    EXPECT_EQ(json["steps"][1]["to"], 3);
    EXPECT_NEAR(json["steps"][1]["icp_deg"].get<double>(), 20.0, 0.2);
}

TEST_F(Replay, ARetakenCaptureIsLeftOut) {
    replace_in_file(session_ / "captures.csv", "cloud\n", "cloud,status,operator\n");
    std::string table = read_text(session_ / "captures.csv");
    std::string changed;
    int line = 0;
    for (std::size_t at = 0; at < table.size(); ++line) {
        const auto end = table.find('\n', at);
        changed += table.substr(at, end - at) +
                   (line == 0   ? ""
                    : line == 3 ? ",superseded,x"
                                : ",,") +
                   "\n";
        at = end + 1;
    }
    write_text(session_ / "captures.csv", changed);
    const auto json = replay("out", {"--json"}).json();
    ASSERT_EQ(json["steps"].size(), 4u);
    EXPECT_EQ(json["steps"][1]["attempts"], 2);
    ASSERT_EQ(json["poses"].size(), 6u) << "one entry for every line";
    EXPECT_TRUE(json["poses"][2].is_null());
    EXPECT_TRUE(json["poses"][3].is_array());
}

/// Composed from the truth: turn_about(axis, −k·10°) maps capture k into the first one.
TEST_F(Replay, PosesMapEveryCaptureIntoTheFirst) {
    const auto json = replay("out", {"--json"}).json();
    for (std::size_t k = 0; k < 6; ++k) {
        const auto pose = pose_from_row_major(json["poses"][k].get<std::array<double, 16>>());
        ASSERT_TRUE(pose);
        const Pose truth =
            turn_about(synthetic_axis(), rad_from_deg(-10.0 * static_cast<double>(k)));
        const Pose rest = truth.inverse() * *pose;
        EXPECT_LT(deg_from_rad(rotation_angle_rad(rest.linear())), 0.12) << k;
        const Eigen::Vector3d p = synthetic_axis().point_m;
        EXPECT_LT((*pose * p - truth * p).norm(), 0.3e-3) << k;
    }
}

TEST_F(Replay, StopsCleanlyOnCtrlC) {
    SyntheticTurnSettings settings;
    settings.captures = 12;
    settings.samples = 60000;
    const fs::path large = folder_ / "large";
    ASSERT_NO_FATAL_FAILURE(write_synthetic_session(large, settings));
    const auto result = interrupt_program(
        {"replay", large.string(), "--out", (folder_ / "out").string()}, [] { return true; });
    EXPECT_EQ(result.status, 4) << result.err;
    EXPECT_THAT(result.err, HasSubstr("cancelled"));
    EXPECT_FALSE(fs::exists(folder_ / "out"));
    EXPECT_EQ(std::distance(fs::directory_iterator(folder_.path()), fs::directory_iterator()), 2)
        << "nothing half-written is left";
}

}  // namespace
}  // namespace gripscan::test
