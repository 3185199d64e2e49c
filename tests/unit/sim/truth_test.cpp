#include "core/sim/truth.h"

#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <numbers>

#include "core/base/units.h"
#include "core/robot/kinematics.h"
#include "tests/support/temporary_folder.h"
#include "tests/unit/sim/small_cell.h"

namespace gripscan::sim {
namespace {

class TruthFiles : public ::testing::Test {
  protected:
    std::unique_ptr<SmallCell> cell = make_small_cell();
    Moments captures;
    test::TemporaryFolder folder;

    void capture(int index, double joint6_deg) {
        Moment moment;
        moment.true_rad = cell->layout.joints_rad;
        moment.true_rad[5] = rad_from_deg(joint6_deg);
        captures[index] = moment;
    }
    [[nodiscard]] TruthSource source() const {
        return {cell->layout, cell->model, cell->region, captures};
    }
    [[nodiscard]] nlohmann::json written() const {
        std::ifstream file(folder / "truth.json");
        return nlohmann::json::parse(file);
    }
    /// Points of visible.ply: position and normal.
    [[nodiscard]] std::vector<std::array<float, 6>> visible() const {
        std::ifstream file(folder / "visible.ply", std::ios::binary);
        std::size_t count = 0;
        for (std::string line; std::getline(file, line) && line != "end_header";) {
            if (line.starts_with("element vertex ")) count = std::stoul(line.substr(15));
        }
        std::vector<std::array<float, 6>> points(count);
        for (auto& point : points) file.read(reinterpret_cast<char*>(point.data()), sizeof point);
        EXPECT_TRUE(file.good());
        return points;
    }
};

TEST_F(TruthFiles, SayWhenThereIsNothingToTell) {
    const Status status = write_truth_files(source(), folder.path(), for_each_in_order);
    ASSERT_FALSE(status);
    EXPECT_NE(status.error().message.find("no capture"), std::string::npos);
    EXPECT_FALSE(std::filesystem::exists(folder / "truth.json"));
}

TEST_F(TruthFiles, PosesBringEveryCaptureIntoTheFirst) {
    for (int k = 0; k < 5; ++k) capture(10 + k, -180.0 + 20.0 * k);
    ASSERT_TRUE(write_truth_files(source(), folder.path(), for_each_in_order));
    const auto json = written();
    EXPECT_EQ(json.at("format"), "gripscan-truth/1");
    ASSERT_EQ(json.at("captures").size(), 5U);
    const Axis axis = joint6_axis_in_camera(cell->layout);
    for (int k = 0; k < 5; ++k) {
        const auto& entry = json.at("captures").at(static_cast<std::size_t>(k));
        EXPECT_EQ(entry.at("index"), 10 + k);
        const auto T = pose_from_row_major(entry.at("T_first_k").get<std::array<double, 16>>());
        ASSERT_TRUE(T);
        // Back by what the joint has turned since.
        EXPECT_TRUE(T->isApprox(turn_about(axis, rad_from_deg(-20.0 * k)), 1e-9));
        EXPECT_NEAR(entry.at("joints_deg").at(5).get<double>(), -180.0 + 20.0 * k, 1e-9);
    }
}

TEST_F(TruthFiles, OneCaptureSeesTheSideThatFacesTheCamera) {
    capture(0, -180.0);
    ASSERT_TRUE(write_truth_files(source(), folder.path(), for_each_in_order));
    const auto points = visible();
    EXPECT_GT(points.size(), 5000U);
    for (const auto& v : points) {
        const Eigen::Vector3d p = Eigen::Vector3f(v[0], v[1], v[2]).cast<double>();
        const Eigen::Vector3d n = Eigen::Vector3f(v[3], v[4], v[5]).cast<double>();
        EXPECT_TRUE(cell->region.contains(p));
        // The left camera is the origin, the right one 0.12 m to the right.
        for (const Eigen::Vector3d& eye : {Eigen::Vector3d(0, 0, 0), Eigen::Vector3d(0.12, 0, 0)}) {
            EXPECT_GT(n.dot((eye - p).normalized()), std::cos(rad_from_deg(75.1)));
        }
    }
}

TEST_F(TruthFiles, AWholeTurnSeesAllSides) {
    capture(0, -180.0);
    ASSERT_TRUE(write_truth_files(source(), folder.path(), for_each_in_order));
    const std::size_t one_side = visible().size();
    for (int k = 1; k < 12; ++k) capture(k, -180.0 + 30.0 * k);
    ASSERT_TRUE(write_truth_files(source(), folder.path(), for_each_in_order));
    const auto points = visible();
    EXPECT_GT(points.size(), 2 * one_side);
    // About the axis, no sixth of a turn is without points.
    const Axis axis = joint6_axis_in_camera(cell->layout);
    std::array<int, 6> sixths{};
    for (const auto& v : points) {
        const Eigen::Vector3d p = Eigen::Vector3f(v[0], v[1], v[2]).cast<double>();
        const Eigen::Vector3d r = p - axis.nearest_to(p);
        const double turn = std::atan2(r.z(), r.y()) / (2.0 * std::numbers::pi) + 0.5;
        ++sixths[std::min<std::size_t>(5, static_cast<std::size_t>(6.0 * turn))];
    }
    for (const int count : sixths) EXPECT_GT(count, 1000);
}

}  // namespace
}  // namespace gripscan::sim
