#include "core/stereo/calibrate.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>

#include "core/base/units.h"
#include "core/stereo/rectifier.h"
#include "core/stereo/stereo_fit.h"
#include "tests/support/test_data.h"
#include "tests/unit/stereo/board_images.h"

namespace gripscan::test {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

fs::path scratch(const std::string& name) {
    const fs::path folder = fs::path(testing::TempDir()) / ("gripscan_calibrate_" + name);
    fs::remove_all(folder);
    return folder;
}

Result<CalibrationResult> calibrate(const BoardFiles& files, const CalibrationBoard& board) {
    return calibrate_stereo(files.lefts, files.rights, board, CalibrationSettings{}, Progress{},
                            for_each_in_order);
}

const Chessboard kChess{9, 6, 0.020};
const CharucoBoard kCharuco{10, 7, 0.020, 0.015, "DICT_5X5_100"};

/// Corner noise of about 0.05 px on 40 px per square leaves some hundredths of a percent in f and
/// a tenth of a millimetre in the baseline; the tolerances are several times that.
void expect_close(const StereoRig& found, const StereoRig& truth) {
    EXPECT_NEAR(found.K_left(0, 0), truth.K_left(0, 0), 3.0);
    EXPECT_NEAR(found.K_right(0, 0), truth.K_right(0, 0), 3.0);
    EXPECT_NEAR(found.baseline_m(), truth.baseline_m(), 0.0004);
    const Eigen::Matrix3d R = found.T_right_left.linear() * truth.T_right_left.linear().transpose();
    EXPECT_LT(deg_from_rad(rotation_angle_rad(R)), 0.15);
    EXPECT_NEAR(found.D_left[0], truth.D_left[0], 0.02);
}

TEST(Calibrate, FindsAKnownRigFromAChessboard) {
    const StereoRig truth = distorted_rig();
    const auto files =
        write_board_images(scratch("chess"), truth, kChess, board_poses(kChess, 9, 0.45, 0.5));
    const auto result = calibrate(files, kChess);
    ASSERT_TRUE(result) << result.error().message;
    expect_close(result->rig, truth);
    EXPECT_FALSE(result->rejected) << result->reason;
    EXPECT_LT(result->rms_px, 0.15);
    EXPECT_LT(result->row_rms_px, 0.1);
    EXPECT_LT(std::abs(result->length_mean_error_m), 1e-4);
    EXPECT_LT(result->length_sd_m, 1.5e-4);
}

TEST(Calibrate, FindsAKnownRigFromACharucoBoard) {
    const StereoRig truth = distorted_rig();
    const auto files = write_board_images(scratch("charuco"), truth, kCharuco,
                                          board_poses(kCharuco, 9, 0.45, 0.5));
    const auto result = calibrate(files, kCharuco);
    ASSERT_TRUE(result) << result.error().message;
    expect_close(result->rig, truth);
    EXPECT_FALSE(result->rejected) << result->reason;
}

TEST(Calibrate, NamesTheImageThatDoesNotFit) {
    const StereoRig truth = distorted_rig();
    auto poses = board_poses(kChess, 9, 0.45, 0.5);
    auto files = write_board_images(scratch("outlier"), truth, kChess, poses);
    // One right image from when the camera had been pushed.
    StereoRig pushed = truth;
    pushed.T_right_left.translation().y() += 0.004;
    const auto wrong = write_board_images(scratch("pushed"), pushed, kChess, {poses[4]});
    files.rights[4] = wrong.rights[0];
    const auto result = calibrate(files, kChess);
    ASSERT_TRUE(result) << result.error().message;
    EXPECT_FALSE(result->views[4].used);
    EXPECT_THAT(result->views[4].problem, HasSubstr("times the median"));
    EXPECT_EQ(std::count_if(result->views.begin(), result->views.end(),
                            [](const CalibrationView& v) { return v.used; }),
              8);
    expect_close(result->rig, truth);
}

TEST(Calibrate, RejectsARigWhoseImagesDoNotBelongTogether) {
    const StereoRig truth = distorted_rig();
    auto poses = board_poses(kChess, 8, 0.45, 0.5);
    auto files = write_board_images(scratch("mixed"), truth, kChess, poses);
    // Every right image is of the next pose: no rig explains them.
    std::rotate(files.rights.begin(), files.rights.begin() + 1, files.rights.end());
    const auto result = calibrate(files, kChess);
    if (!result) {
        EXPECT_THAT(result.error().message, HasSubstr("pairs show the board well enough"));
        return;
    }
    EXPECT_TRUE(result->rejected);
    EXPECT_FALSE(result->reason.empty());
}

TEST(Calibrate, RefusesBoardsThatAreAllParallel) {
    const auto files = write_board_images(scratch("parallel"), distorted_rig(), kChess,
                                          board_poses(kChess, 6, 0.45, 0.0));
    const auto result = calibrate(files, kChess);
    ASSERT_FALSE(result);
    EXPECT_THAT(result.error().message, HasSubstr("tilt it"));
}

TEST(Calibrate, SaysWhichImagesShowNoBoard) {
    const StereoRig truth = distorted_rig();
    auto files =
        write_board_images(scratch("few"), truth, kChess, board_poses(kChess, 5, 0.45, 0.5));
    const auto other = write_board_images(scratch("few_other"), truth, Chessboard{5, 4, 0.03},
                                          board_poses(Chessboard{5, 4, 0.03}, 1, 0.45, 0.3));
    files.lefts[2] = other.lefts[0];
    const auto result = calibrate(files, kChess);
    ASSERT_FALSE(result);
    EXPECT_THAT(result.error().message, HasSubstr("4 of 5 pairs"));
    EXPECT_THAT(result.error().message, HasSubstr("no board found in the left image"));
}

TEST(Calibrate, RefusesUnequalListsAndBadBoards) {
    EXPECT_FALSE(calibrate({{"a.png"}, {}}, kChess));
    const auto missing = calibrate({{"/nowhere/a.png"}, {"/nowhere/b.png"}}, kChess);
    ASSERT_FALSE(missing);
    EXPECT_THAT(missing.error().message, HasSubstr("/nowhere/a.png"));
    EXPECT_FALSE(validate(CalibrationBoard{Chessboard{2, 6, 0.02}}));
    EXPECT_FALSE(validate(CalibrationBoard{Chessboard{9, 6, -0.02}}));
    EXPECT_FALSE(validate(CalibrationBoard{CharucoBoard{7, 5, 0.02, 0.03, "DICT_5X5_100"}}));
    EXPECT_FALSE(validate(CalibrationBoard{CharucoBoard{7, 5, 0.02, 0.01, "DICT_9X9"}}));
    EXPECT_FALSE(validate(CalibrationBoard{CharucoBoard{20, 20, 0.02, 0.01, "4X4_50"}}));
}

TEST(BoardOrder, IsMadeTheSameInBothImages) {
    BoardView left;
    for (int i = 0; i < 9; ++i) {
        left.number.push_back(i);
        left.corner_px.emplace_back(10.0F * static_cast<float>(i % 3),
                                    11.0F * static_cast<float>(i / 3));
    }
    const Chessboard square{3, 3, 0.01};
    BoardView reversed = left;
    std::reverse(reversed.corner_px.begin(), reversed.corner_px.end());
    EXPECT_EQ(in_order_of(left, reversed, square).corner_px, left.corner_px);
    BoardView quarter = left;
    for (int i = 0; i < 9; ++i) {
        quarter.corner_px[static_cast<std::size_t>(i)] =
            left.corner_px[static_cast<std::size_t>((2 - i % 3) * 3 + i / 3)];
    }
    EXPECT_EQ(in_order_of(left, quarter, square).corner_px, left.corner_px);
}

/// Bumblebee2 recordings: 5 x 7 squares of 30 mm.
TEST(CalibrateBumblebee, MeasuresBaselineAndBoard) {
    GRIPSCAN_TEST_DATA(folder, "bumblebee2");
    BoardFiles files;
    for (int i = 1; i <= 11; ++i) {
        files.lefts.push_back(folder / "chess" / fmt::format("left{:02}.jpg", i));
        files.rights.push_back(folder / "chess" / fmt::format("right{:02}.jpg", i));
    }
    const auto result = calibrate(files, Chessboard{4, 6, 0.030});
    ASSERT_TRUE(result) << result.error().message;
    std::cout << "baseline " << result->rig.baseline_m() * 1000 << " mm, rms " << result->rms_px
              << " px, rows " << result->row_rms_px << " / " << result->row_max_px
              << " px, lengths " << result->length_mean_error_m * 1000 << " +- "
              << result->length_sd_m * 1000 << " mm, f " << result->rig.K_left(0, 0) << " "
              << result->rig.K_left(1, 1) << ", " << result->distortion_model << "\n";
    for (const CalibrationView& v : result->views) {
        std::cout << v.left.filename().string() << " " << v.rms_left_px << " " << v.rms_right_px
                  << " " << v.problem << "\n";
    }
    EXPECT_FALSE(result->rejected) << result->reason;
    EXPECT_NEAR(result->rig.baseline_m(), 0.12005, 0.0005);
    EXPECT_NEAR(result->rig.K_left(0, 0), 524.6, 5.2);
    EXPECT_LT(result->length_sd_m, 0.00015);
    EXPECT_LT(std::abs(result->length_mean_error_m), 0.00005);
    EXPECT_LT(result->row_rms_px, 0.1);
}

}  // namespace
}  // namespace gripscan::test
