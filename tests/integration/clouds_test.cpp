// align, stereo, export and report as programs.

#include <gmock/gmock.h>

#include <cmath>

#include "core/camera/pfm_file.h"
#include "tests/integration/program.h"
#include "tests/support/synthetic_session.h"
#include "tests/support/test_data.h"

namespace gripscan::test {
namespace {

using testing::HasSubstr;
namespace fs = std::filesystem;

class OfASession : public testing::Test {
  protected:
    void SetUp() override { ASSERT_NO_FATAL_FAILURE(write_synthetic_session(session_)); }
    [[nodiscard]] std::string cloud(int k) const {
        return (session_ / fmt::format("clouds/{:03}.pcd", k)).string();
    }
    TemporaryFolder folder_;
    fs::path session_ = folder_ / "sitzung";
};

using Align = OfASession;

TEST_F(Align, FindsTheMotionWithoutBeingToldTheAngle) {
    const auto result = run_program({"align", cloud(0), cloud(2), "--json"});
    EXPECT_EQ(result.status, 0) << result.err << result.out;
    const auto json = result.json();
    EXPECT_NEAR(json["angle_deg"].get<double>(), 20.0, 0.15);
    EXPECT_EQ(json["verdict"], "accept");
    EXPECT_TRUE(json["starts_agree"].get<bool>());
    for (const char* key : {"T", "axis", "roll_deg", "pitch_deg", "yaw_deg", "overlap", "rms_mm",
                            "sigma_deg", "observability", "cause"}) {
        EXPECT_TRUE(json.contains(key)) << key;
    }
    const auto T = pose_from_row_major(json["T"].get<std::array<double, 16>>());
    ASSERT_TRUE(T);
    const Pose truth = turn_about(synthetic_axis(), rad_from_deg(20.0));
    EXPECT_LT((*T * synthetic_axis().point_m - truth * synthetic_axis().point_m).norm(), 0.3e-3)
        << "T maps SOURCE onto TARGET";
}

TEST_F(Align, ComparesWithTheSizeOfTheAngleItIsGiven) {
    const auto with = [&](const std::string& deg) {
        return run_program({"align", cloud(0), cloud(1), "--rotation-deg", deg, "--json"});
    };
    EXPECT_EQ(with("10").status, 0);
    EXPECT_EQ(with("-10").status, 0) << "the angle is compared with |A|";
    const auto near = with("10.7");
    EXPECT_EQ(near.status, 1);
    EXPECT_EQ(near.json()["verdict"], "check");
    const auto wrong = with("15");
    EXPECT_EQ(wrong.status, 1);
    EXPECT_EQ(wrong.json()["verdict"], "reject");
    EXPECT_EQ(wrong.json()["T"], with("10").json()["T"]) << "the angle must not steer the result";
}

TEST_F(Align, RefusesWhatItCannotRead) {
    const auto result = run_program({"align", cloud(0), (folder_ / "none.pcd").string()});
    EXPECT_EQ(result.status, 2);
    EXPECT_THAT(result.err, HasSubstr("none.pcd"));
}

using Export = OfASession;

TEST_F(Export, WritesEveryFormAndReadsItBack) {
    ASSERT_EQ(run_program({"replay", session_.string(), "--quiet"}).status, 0);
    const auto original = load_cloud(session_ / "results/template.pcd");
    ASSERT_TRUE(original);
    const auto exported = [&](const std::string& file, const Arguments& more) {
        Arguments arguments{"export", session_.string(), "--out", (folder_ / file).string(),
                            "--json"};
        arguments.insert(arguments.end(), more.begin(), more.end());
        const auto result = run_program(arguments);
        EXPECT_EQ(result.status, 0) << file << result.err;
        EXPECT_EQ(result.json()["points"], original->size()) << file;
        return folder_ / file;
    };
    for (const auto& path :
         {exported("a.pcd", {"--encoding", "ascii"}), exported("b.pcd", {"--encoding", "binary"}),
          exported("c.pcd", {"--encoding", "compressed"}), exported("d.ply", {}),
          exported("e.xyz", {})}) {
        const auto cloud = load_cloud(path);
        ASSERT_TRUE(cloud) << cloud.error().message;
        ASSERT_EQ(cloud->size(), original->size()) << path;
        EXPECT_EQ(cloud->points, original->points) << path;
    }
    EXPECT_EQ(load_cloud(folder_ / "c.pcd")->seen, original->seen);
    const auto mm = load_cloud(exported("mm.ply", {"--unit", "mm"}));
    ASSERT_TRUE(mm);
    EXPECT_NEAR(mm->points[7].z(), 1000.0f * original->points[7].z(), 1e-3f);
}

TEST_F(Export, InTheAxisFrameTheAxisIsZ) {
    ASSERT_EQ(run_program({"replay", session_.string(), "--quiet"}).status, 0);
    ASSERT_EQ(run_program({"export", session_.string(), "--out", (folder_ / "x.pcd").string(),
                           "--frame", "axis"})
                  .status,
              0);
    const auto camera = load_cloud(session_ / "results/template.pcd");
    const auto axis = load_cloud(folder_ / "x.pcd");
    ASSERT_TRUE(camera && axis);
    for (std::size_t i = 0; i < camera->size(); i += 97) {
        const double radius = axis->points[i].head<2>().norm();
        EXPECT_NEAR(radius, synthetic_axis().distance_m(camera->points[i].cast<double>()), 0.3e-3);
    }
    EXPECT_NEAR(centroid(*axis).z(), 0.0, 1e-6);
}

TEST_F(Export, ComputesWhereThereAreNoResultsYet) {
    const auto before = content_of(session_);
    const auto result =
        run_program({"export", session_.string(), "--out", (folder_ / "x.ply").string()});
    EXPECT_EQ(result.status, 0) << result.err;
    EXPECT_EQ(content_of(session_), before);
}

TEST_F(Export, RefusesAnUnknownExtension) {
    ASSERT_EQ(run_program({"replay", session_.string(), "--quiet"}).status, 0);
    const auto result =
        run_program({"export", session_.string(), "--out", (folder_ / "x.doc").string()});
    EXPECT_EQ(result.status, 2);
    EXPECT_FALSE(fs::exists(folder_ / "x.doc"));
}

using ReportCommand = OfASession;

TEST_F(ReportCommand, MakesTheSameFilesAgain) {
    ASSERT_EQ(run_program({"replay", session_.string(), "--quiet"}).status, 0);
    const auto result = run_program(
        {"report", session_.string(), "--out", (folder_ / "report").string(), "--json"});
    EXPECT_EQ(result.status, 0) << result.err;
    EXPECT_EQ(result.json()["steps"], 5);
    for (const char* file : {"turns.csv", "report.html"}) {
        EXPECT_EQ(read_text(folder_ / "report" / file), read_text(session_ / "results" / file));
    }
    EXPECT_THAT(run_program({"report", session_.string()}).out, HasSubstr("5 of 5 steps accepted"));
}

TEST(StereoCommand, MakesACloudAndADisparityFile) {
    GRIPSCAN_TEST_DATA(data, "rendered-part");
    const TemporaryFolder folder;
    const auto run = [&](const Arguments& more) {
        Arguments arguments{"stereo",
                            (data / "frames/000_left.png").string(),
                            (data / "frames/000_right.png").string(),
                            "--rig",
                            (data / "rig.yaml").string(),
                            "--out",
                            (folder / "c.pcd").string(),
                            "--json"};
        arguments.insert(arguments.end(), more.begin(), more.end());
        return run_program(arguments);
    };
    const auto result = run({"--disparity", (folder / "d.pfm").string(), "--min-disparity", "96",
                             "--num-disparities", "128"});
    ASSERT_EQ(result.status, 0) << result.err;
    const auto cloud = load_cloud(folder / "c.pcd");
    ASSERT_TRUE(cloud) << cloud.error().message;
    EXPECT_EQ(result.json()["cloud"]["points"], cloud->size());
    const auto disparity = load_pfm(folder / "d.pfm");
    ASSERT_TRUE(disparity) << disparity.error().message;
    ASSERT_EQ(disparity->cols, 1280);
    ASSERT_EQ(disparity->rows, 960);
    EXPECT_THAT(read_text(folder / "d.pfm"), testing::StartsWith("Pf\n1280 960\n-1\n"));
    // Z = f·B/d for the rig of this data set: f 985 px, B 0.12 m, principal point (639.5, 479.5).
    std::size_t compared = 0;
    for (std::size_t i = 0; i < cloud->size(); i += 101) {
        const Eigen::Vector3d p = cloud->points[i].cast<double>();
        const int u = static_cast<int>(std::lround(985.0 * p.x() / p.z() + 639.5));
        const int v = static_cast<int>(std::lround(985.0 * p.y() / p.z() + 479.5));
        const double d = disparity->at<float>(v, u);
        if (!std::isfinite(d)) continue;
        EXPECT_NEAR(985.0 * 0.12 / d, p.z(), 1e-4) << u << " " << v;
        ++compared;
    }
    EXPECT_GT(compared, cloud->size() / 101 / 2);
    const auto refused = run({"--rig", (folder / "none.yaml").string()});
    EXPECT_EQ(refused.status, 2);
}

}  // namespace
}  // namespace gripscan::test
