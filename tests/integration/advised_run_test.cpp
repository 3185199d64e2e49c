// Faults of the cell in runs of the program: the advisor names the cause, nothing bad is merged,
// and the same command twice is the same run.
#include <gmock/gmock.h>

#include "tests/integration/program.h"
#include "tests/support/temporary_folder.h"

namespace gripscan::test {
namespace {

using testing::HasSubstr;
namespace fs = std::filesystem;

struct FaultyRun {
    const char* fault;
    const char* cause;
    int first_bad;  ///< number of the first step that shows it
};

class AdvisedRun : public testing::TestWithParam<FaultyRun> {};

TEST_P(AdvisedRun, NamesTheCauseAndMergesNothingBad) {
    const FaultyRun& now = GetParam();
    const TemporaryFolder folder;
    const auto result =
        run_program({"run", "gripper", "--cell", "sim", "--step-deg", "20", "--seed", "3",
                     "--fault", now.fault, "--out", (folder / "s").string(), "--json"});
    EXPECT_EQ(result.status, 1) << result.err;
    EXPECT_THAT(result.err, HasSubstr(std::string("cause=") + now.cause + " action=stop"));
    const auto json = result.json();
    ASSERT_TRUE(json.contains("steps")) << result.out << result.err;
    ASSERT_GE(json["steps"].size(), static_cast<std::size_t>(now.first_bad));
    for (const auto& step : json["steps"]) {
        const int index = step["index"];
        if (index < now.first_bad) {
            EXPECT_EQ(step["verdict"], "accept") << index << ": " << step["sentence"];
        } else {
            EXPECT_EQ(step["verdict"], "reject") << index << ": " << step["sentence"];
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Faults, AdvisedRun,
                         testing::Values(FaultyRun{"slip@3", "slip", 3},
                                         FaultyRun{"bump@3", "moved_camera", 3},
                                         FaultyRun{"sign@2", "sign", 2},
                                         FaultyRun{"intruder@3", "mislabelled", 3}),
                         [](const auto& test) {
                             const std::string name = test.param.fault;
                             return name.substr(0, name.find('@'));
                         });

/// A reflection that one picture shows and the next does not: taken again, and nothing is lost.
TEST(AdvisedRun, AGlareIsRetakenAndTheTurnCompleted) {
    const TemporaryFolder folder;
    const auto result =
        run_program({"run", "gripper", "--cell", "sim", "--step-deg", "30", "--seed", "2",
                     "--fault", "glare@3", "--out", (folder / "s").string(), "--json"});
    EXPECT_EQ(result.status, 0) << result.err;
    EXPECT_THAT(result.err, HasSubstr("action=retake"));
    const auto json = result.json();
    ASSERT_EQ(json["steps"].size(), 12U);
    for (const auto& step : json["steps"]) EXPECT_EQ(step["verdict"], "accept");
}

TEST(AdvisedRun, TheSameCommandTwiceIsTheSameRun) {
    const TemporaryFolder folder;
    const fs::path session = folder / "s";
    std::vector<ProgramResult> results;
    std::vector<std::vector<std::pair<std::string, std::string>>> files;
    for (int i = 0; i < 2; ++i) {
        results.push_back(run_program({"run", "gripper", "--cell", "sim", "--step-deg", "30",
                                       "--seed", "6", "--out", session.string(), "--json"}));
        ASSERT_EQ(results.back().status, 0) << results.back().err;
        files.push_back(content_of(session / "results"));
        fs::remove_all(session);
    }
    EXPECT_EQ(results[0].out, results[1].out);
    EXPECT_EQ(files[0], files[1]);
}

}  // namespace
}  // namespace gripscan::test
