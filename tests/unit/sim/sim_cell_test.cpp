#include "core/sim/sim_cell.h"

#include <gtest/gtest.h>

#include <opencv2/core.hpp>

#include "core/base/units.h"
#include "tests/support/temporary_folder.h"

namespace gripscan {
namespace {

std::string error_of(const SimCellSettings& settings) {
    const auto cell = SimCell::create(settings);
    return cell ? "" : cell.error().message;
}

TEST(SimCell, SaysWhatIsWrongWithItsSettings) {
    EXPECT_NE(error_of({.gripper = "magnet"}).find("'magnet'; there are two-finger"),
              std::string::npos);
    EXPECT_NE(error_of({.object = "egg"}).find("'egg'; there are carton"), std::string::npos);
    EXPECT_NE(error_of({.noise_levels = -1.0}).find("noise"), std::string::npos);
    EXPECT_NE(error_of({.blur_px = 1e9}).find("blur"), std::string::npos);
    EXPECT_NE(error_of({.texture_contrast = std::nan("")}).find("contrast"), std::string::npos);
    EXPECT_GE(sim_grippers().size(), 5U);
    EXPECT_GE(sim_objects().size(), 5U);
}

TEST(SimCell, ShowsTheArmAsItStands) {
    auto cell = SimCell::create({.seed = 2});
    ASSERT_TRUE(cell);
    EXPECT_EQ(cell->start_joint6_rad(), rad_from_deg(-180.0));
    const auto start = cell->robot().read();
    ASSERT_TRUE(start);
    EXPECT_NEAR(deg_from_rad(start->joints_rad[5]), -180.0, 0.05);

    const auto first = cell->source().grab({0, 1});
    ASSERT_TRUE(first);
    EXPECT_EQ(first->left.type(), CV_8U);
    EXPECT_EQ(first->left.size(), cv::Size(1280, 960));
    EXPECT_EQ(first->right.size(), cv::Size(1280, 960));
    ASSERT_TRUE(cell->robot().turn_joint6({1, cell->start_joint6_rad() + rad_from_deg(10.0)}, {}));
    const auto second = cell->source().grab({1, 1});
    ASSERT_TRUE(second);
    cv::Mat changed;
    cv::absdiff(first->left, second->left, changed);
    // Noise alone hardly reaches 15 levels (five of its deviations); the gripper's change does.
    EXPECT_GT(cv::countNonZero(changed > 15), 2000);

    // The cell moves like the value it is, and goes on working.
    SimCell moved = std::move(*cell);
    ASSERT_TRUE(moved.source().grab({2, 1}));
    const test::TemporaryFolder folder;
    ASSERT_TRUE(moved.write_truth(folder / "truth"));
    for (const char* name : {"truth.json", "surface.ply", "visible.ply"}) {
        EXPECT_TRUE(std::filesystem::exists(folder / "truth" / name));
    }
}

TEST(SimCell, WithoutArmTheRegionIsEmptyAndTheSame) {
    auto with = SimCell::create({.seed = 5});
    auto without = SimCell::create({.seed = 5, .with_arm = false});
    ASSERT_TRUE(with && without);
    EXPECT_EQ(with->region().min_m, without->region().min_m);
    EXPECT_EQ(with->region().max_m, without->region().max_m);
    const auto first = without->source().grab({0, 1});
    ASSERT_TRUE(without->robot().turn_joint6({1, 1.0}, {}));
    const auto second = without->source().grab({0, 1});
    ASSERT_TRUE(first && second);
    EXPECT_EQ(cv::countNonZero(first->left != second->left), 0);
}

}  // namespace
}  // namespace gripscan
