#include "core/report/results_folder.h"

#include <gmock/gmock.h>

#include <set>

#include "core/cloud/cloud_file.h"
#include "core/geometry/axis_frame.h"
#include "tests/support/synthetic_session.h"
#include "tests/unit/report/sample_report.h"

namespace gripscan {
namespace {

using testing::HasSubstr;
namespace fs = std::filesystem;

class ResultsFolder : public testing::Test {
  protected:
    void SetUp() override {
        test::SyntheticTurnSettings settings;
        settings.captures = 3;
        settings.samples = 400;
        ASSERT_NO_FATAL_FAILURE(test::write_synthetic_session(folder_ / "s", settings));
        auto opened = open_session(folder_ / "s");
        ASSERT_TRUE(opened) << opened.error().message;
        session_ = std::move(*opened);
        settings_ = compute_settings_of(session_);
    }

    Status write(const fs::path& out) {
        return write_results(out, test::sample_report(), {session_, settings_, "1.2.3"});
    }
    std::string target_problem(const fs::path& out) const {
        const Status status = check_results_target(folder_ / "s", out);
        return status ? "no problem" : status.error().message;
    }

    test::TemporaryFolder folder_;
    Session session_;
    ComputeTurnSettings settings_;
};

TEST_F(ResultsFolder, HoldsExactlyWhatTheContractNames) {
    const Status written = write(folder_ / "out");
    ASSERT_TRUE(written) << written.error().message;
    std::set<std::string> names;
    for (const auto& entry : fs::directory_iterator(folder_ / "out")) {
        names.insert(entry.path().filename().string());
    }
    EXPECT_EQ(names, (std::set<std::string>{"turns.csv", "turns.json", "template.pcd",
                                            "template.json", "report.html"}));
    const auto merged = load_cloud(folder_ / "out/template.pcd");
    ASSERT_TRUE(merged) << merged.error().message;
    EXPECT_EQ(merged->size(), 2u);
    const auto document = load_results(folder_ / "out");
    ASSERT_TRUE(document) << document.error().message;
    EXPECT_EQ(document->merged.path, "template.pcd");
    EXPECT_EQ(document->report.steps.size(), 3u);
}

TEST_F(ResultsFolder, IsReplacedAsAWhole) {
    ASSERT_TRUE(write(folder_ / "out"));
    test::write_text(folder_ / "out/turns.csv", "old");
    ASSERT_TRUE(write(folder_ / "out"));
    EXPECT_THAT(test::read_text(folder_ / "out/turns.csv"), HasSubstr("icp_deg"));
    EXPECT_EQ(std::distance(fs::directory_iterator(folder_.path()), fs::directory_iterator()), 2)
        << "nothing is left beside it";
}

TEST_F(ResultsFolder, RemembersItsSources) {
    ASSERT_TRUE(write(folder_ / "out"));
    const std::string before = test::read_text(folder_ / "out/template.json");
    EXPECT_THAT(before, HasSubstr("clouds/001.pcd"));
    EXPECT_THAT(before, HasSubstr("\"unit\": \"m\""));
    ASSERT_TRUE(write(folder_ / "out"));
    EXPECT_EQ(test::read_text(folder_ / "out/template.json"), before);
    std::string bytes = test::read_text(folder_ / "s/clouds/001.pcd");
    bytes.back() = static_cast<char>(bytes.back() ^ 1);
    test::write_text(folder_ / "s/clouds/001.pcd", bytes);
    ASSERT_TRUE(write(folder_ / "out"));
    EXPECT_NE(test::read_text(folder_ / "out/template.json"), before) << "one bit is enough";
}

TEST_F(ResultsFolder, ReplacesNothingButResults) {
    EXPECT_EQ(target_problem(folder_ / "new/deep"), "no problem");
    EXPECT_EQ(target_problem(folder_ / "s/results"), "no problem");
    ASSERT_TRUE(write(folder_ / "out"));
    EXPECT_EQ(target_problem(folder_ / "out"), "no problem");
    EXPECT_EQ(target_problem(folder_ / "out/"), "no problem");
    EXPECT_THAT(target_problem(folder_ / "s"), HasSubstr("holds the session"));
    EXPECT_THAT(target_problem(folder_.path()), HasSubstr("holds the session"));
    EXPECT_THAT(target_problem(folder_ / "s/clouds"), HasSubstr("holds '"));
    test::write_text(folder_ / "file", "x");
    EXPECT_THAT(target_problem(folder_ / "file"), HasSubstr("it is a file"));
    EXPECT_THAT(target_problem(folder_ / "file/below"), HasSubstr("not a folder"));
    test::write_text(folder_ / "out/notes.txt", "precious");
    EXPECT_THAT(target_problem(folder_ / "out"), HasSubstr("notes.txt"));
}

TEST(AxisFrame, LiesOnTheAxisAndTurnsItIntoZ) {
    const Eigen::Vector3d centroid(0.03, -0.02, 0.7);
    for (const Eigen::Vector3d& direction :
         {Eigen::Vector3d(1, 0.02, -0.05), Eigen::Vector3d(0.1, 1, 0.2),
          Eigen::Vector3d(0, 0, -1)}) {
        const Axis axis{{0.01, 0.02, 0.6}, direction.normalized()};
        const Pose T = T_axis_camera(axis, centroid);
        EXPECT_NEAR((T.linear() * T.linear().transpose() - Eigen::Matrix3d::Identity()).norm(), 0,
                    1e-12);
        EXPECT_NEAR(T.linear().determinant(), 1.0, 1e-12);
        EXPECT_NEAR((T.linear() * axis.direction - Eigen::Vector3d::UnitZ()).norm(), 0.0, 1e-12);
        EXPECT_NEAR((T * axis.nearest_to(centroid)).norm(), 0.0, 1e-12);
        EXPECT_NEAR((T * centroid).z(), 0.0, 1e-12) << "the centroid is level with the origin";
    }
}

}  // namespace
}  // namespace gripscan
