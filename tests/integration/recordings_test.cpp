// What gripscan promises on recordings with a known turn, through the program; prints its figures.

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <iostream>

#include "core/base/units.h"
#include "core/cloud/cloud_file.h"
#include "core/geometry/axis.h"
#include "core/session/session.h"
#include "tests/integration/program.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/test_data.h"

namespace gripscan::test {
namespace {
namespace fs = std::filesystem;

TEST(Recordings, PhotographsOfATempleTurnByWhatIsPublished) {
    GRIPSCAN_TEST_DATA(session, "temple-turn");
    const TemporaryFolder folder;
    const auto result =
        run_program({"replay", session.string(), "--out", (folder / "out").string(), "--json"});
    EXPECT_EQ(result.status, 0) << result.err;
    const auto json = result.json();
    ASSERT_EQ(json["steps"].size(), 8u);
    double sum = 0.0;
    double worst = 0.0;
    for (const auto& step : json["steps"]) {
        const double angle = step["icp_deg"].get<double>();
        EXPECT_NEAR(angle, 7.66, 0.35);
        worst = std::max(worst, std::abs(angle - 7.66));
        sum += angle;
    }
    std::cout << "temple-turn: worst step " << worst << " deg off, mean " << sum / 8.0 << ", sum "
              << sum << " deg\n";
    EXPECT_NEAR(sum / 8.0, 7.66, 0.15);
    EXPECT_NEAR(sum, 61.28, 0.8);
    EXPECT_TRUE(json["closure"].is_null()) << "61 degrees are no whole turn";
}

TEST(Recordings, WithoutTheCropLittleLiesOutsideTheTemple) {
    GRIPSCAN_TEST_DATA(data, "temple-turn");
    const TemporaryFolder folder;
    const auto result = run_program(
        {"replay", data.string(), "--out", (folder / "out").string(), "--no-crop", "--quiet"});
    EXPECT_LE(result.status, 1) << result.err;
    const auto session = open_session(data);
    ASSERT_TRUE(session);
    const auto merged = load_cloud(folder / "out/template.pcd");
    ASSERT_TRUE(merged) << merged.error().message;
    ASSERT_FALSE(merged->seen.empty());
    std::size_t twice = 0;
    std::size_t inside = 0;
    for (std::size_t i = 0; i < merged->size(); ++i) {
        if (merged->seen[i] < 2) continue;
        ++twice;
        inside += session->spec.region->contains(merged->points[i].cast<double>());
    }
    std::cout << "temple-turn without the crop: "
              << 100.0 * static_cast<double>(inside) / static_cast<double>(twice) << " % of "
              << twice << " points inside the region\n";
    EXPECT_GT(static_cast<double>(inside), 0.95 * static_cast<double>(twice)) << twice;
}

TEST(Recordings, ARenderedPartTurnsByTenDegreesAndItsPosesAreTrue) {
    GRIPSCAN_TEST_DATA(session, "rendered-part");
    const TemporaryFolder folder;
    const auto result =
        run_program({"replay", session.string(), "--out", (folder / "out").string(), "--json"});
    EXPECT_EQ(result.status, 0) << result.err;
    const auto json = result.json();
    ASSERT_EQ(json["steps"].size(), 12u);
    double sum = 0.0;
    double worst = 0.0;
    for (const auto& step : json["steps"]) {
        const double error = std::abs(step["icp_deg"].get<double>() - 10.0);
        EXPECT_LE(error, 0.50) << step["index"];
        worst = std::max(worst, error);
        sum += error;
    }
    std::cout << "rendered-part: mean |error| " << sum / 12.0 << " deg, worst " << worst
              << " deg\n";
    EXPECT_LE(sum / 12.0, 0.18);
    const auto truth = nlohmann::json::parse(read_text(session / "truth.json"));
    const auto vector = [&](const char* key) {
        const auto v = truth[key].get<std::array<double, 3>>();
        return Eigen::Vector3d(v[0], v[1], v[2]);
    };
    const Axis axis{vector("axis_origin"), vector("axis_dir").normalized()};
    const auto p = json["axis"]["point_m"].get<std::array<double, 3>>();
    const Eigen::Vector3d point(p[0], p[1], p[2]);
    double worst_deg = 0.0;
    double worst_mm = 0.0;
    for (std::size_t k = 0; k < 13; ++k) {
        const auto pose = pose_from_row_major(json["poses"][k].get<std::array<double, 16>>());
        ASSERT_TRUE(pose);
        const Pose true_pose = turn_about(axis, rad_from_deg(-10.0 * static_cast<double>(k)));
        const Pose rest = true_pose.inverse() * *pose;
        worst_deg = std::max(worst_deg, deg_from_rad(rotation_angle_rad(rest.linear())));
        worst_mm = std::max(worst_mm, kMmPerM * (*pose * point - true_pose * point).norm());
    }
    std::cout << "rendered-part: poses within " << worst_deg << " deg, " << worst_mm << " mm\n";
    EXPECT_LE(worst_deg, 0.08);
    EXPECT_LE(worst_mm, 0.3);
}

}  // namespace
}  // namespace gripscan::test
