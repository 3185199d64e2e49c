// Eight photographs from a camera on the flange of a real arm, against the result published with
// them. And rendered boards on the flange of a robot before a stereo camera.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/alignment/robot_alignment.h"
#include "core/base/units.h"
#include "core/camera/image_file.h"
#include "core/robot/kinematics.h"
#include "core/session/alignment_file.h"
#include "core/session/robot_poses_file.h"
#include "tests/support/random_pose.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/test_data.h"
#include "tests/support/visp_poses.h"
#include "tests/unit/stereo/board_images.h"

namespace gripscan {
namespace {
double apart_mm(const Pose& a, const Pose& b) {
    return kMmPerM * (a.translation() - b.translation()).norm();
}
double apart_deg(const Pose& a, const Pose& b) {
    return deg_from_rad(rotation_angle_rad(a.linear().transpose() * b.linear()));
}

Result<RobotAlignment> aligned(const RobotPosesFile& file, const BoardEye& eye) {
    std::vector<AlignmentView> views;
    for (const RobotPoseRow& row : file.rows) {
        const auto left = load_grey_image(row.left);
        const cv::Mat right = row.right.empty() ? cv::Mat() : load_grey_image(row.right).value();
        auto seen = eye.look(left.value(), right);
        EXPECT_TRUE(seen) << row.left;
        if (seen) views.push_back({row.T_robot_flange, std::move(*seen)});
    }
    return align_robot(views, eye.camera(), file.mounting, AlignmentLimits{}, {});
}

TEST(VispEyeInHand, ParkAgreesWithThePublishedResult) {
    GRIPSCAN_TEST_DATA(data, "visp-eye-in-hand");
    const test::TemporaryFolder folder;
    test::write_visp_poses(data, folder / "poses.yaml");
    const auto file = load_robot_poses(folder / "poses.yaml");
    ASSERT_TRUE(file) << file.error().message;
    const auto eye = BoardEye::create(file->camera, file->board);
    ASSERT_TRUE(eye) << eye.error().message;
    const auto alignment = aligned(*file, *eye);
    ASSERT_TRUE(alignment) << alignment.error().message;
    const Pose published = test::visp_reference(data);
    for (const HandEyeCandidate& c : alignment->candidates) {
        std::printf("%-12s %.3f deg %.3f mm, spread rms %.2f mm %.3f deg\n", c.method.c_str(),
                    apart_deg(c.poses.X, published), apart_mm(c.poses.X, published),
                    kMmPerM * c.spread.rms_m, deg_from_rad(c.spread.rms_rad));
    }
    std::printf(
        "refined      %.3f deg %.3f mm, spread rms %.2f mm %.3f deg, max %.2f mm %.3f deg, "
        "%.2f px, sd %.2f mm %.3f deg\n",
        apart_deg(alignment->poses.X, published), apart_mm(alignment->poses.X, published),
        kMmPerM * alignment->spread.rms_m, deg_from_rad(alignment->spread.rms_rad),
        kMmPerM * alignment->spread.max_m, deg_from_rad(alignment->spread.max_rad),
        alignment->reprojection_px, kMmPerM * alignment->sd_m, deg_from_rad(alignment->sd_rad));
    const HandEyeCandidate& park = alignment->candidates.front();
    EXPECT_EQ(park.method, "Park");
    // What plain OpenCV gives with these photographs, and half of it again for other corners.
    EXPECT_LT(apart_deg(park.poses.X, published), 0.04);
    EXPECT_LT(apart_mm(park.poses.X, published), 0.15);
    EXPECT_FALSE(alignment->rejected) << alignment->reason;
    // These robot poses are off by millimetres: refining on pixels would make the views agree
    // worse.
    EXPECT_FALSE(alignment->refined);
    EXPECT_LT(apart_deg(alignment->poses.X, published), 0.04);
    EXPECT_LT(apart_mm(alignment->poses.X, published), 0.15);
}

struct BoardCase {
    const char* name;
    CalibrationBoard board;
};

class RenderedBoards : public testing::TestWithParam<BoardCase> {};

TEST_P(RenderedBoards, GiveTheCameraBackInTheRobotsFrame) {
    const test::TemporaryFolder folder;
    const StereoRig rig = test::distorted_rig();
    const auto boards = test::board_poses(GetParam().board, 10, 0.6, 0.6);
    const auto files =
        test::write_board_images(folder.path() / "images", rig, GetParam().board, boards);
    SeededRandom random(4);
    const Pose T_robot_left = test::random_pose(random, 1.0);
    Pose T_flange_board = test::random_pose(random, 1.0);
    T_flange_board.translation() *= 0.05;
    RobotPosesFile file;
    file.board = GetParam().board;
    const auto eye = BoardEye::create(rig, file.board);
    ASSERT_TRUE(eye) << eye.error().message;
    for (std::size_t i = 0; i < boards.size(); ++i) {
        file.rows.push_back(
            {files.lefts[i], files.rights[i], T_robot_left * boards[i] * T_flange_board.inverse()});
    }
    const auto alignment = aligned(file, *eye);
    ASSERT_TRUE(alignment) << alignment.error().message;
    EXPECT_FALSE(alignment->rejected) << alignment->reason;
    // The camera frame is turned against the left camera by the rectification alone: the place is
    // the same. Corners are good to about 0.05 px; the boards lie 0.6 m away.
    EXPECT_LT(apart_mm(alignment->poses.X, T_robot_left), 1.0);
    EXPECT_LT(alignment->reprojection_px, 0.3);
    std::printf("%s: %.3f mm, sd %.3f mm, %.3f px\n", GetParam().name,
                apart_mm(alignment->poses.X, T_robot_left), kMmPerM * alignment->sd_m,
                alignment->reprojection_px);
}

INSTANTIATE_TEST_SUITE_P(Boards, RenderedBoards,
                         testing::Values(BoardCase{"Chessboard", Chessboard{9, 6, 0.020}},
                                         BoardCase{"Charuco", CharucoBoard{9, 7, 0.022, 0.016,
                                                                           "DICT_5X5_100"}}),
                         [](const auto& one) { return std::string(one.param.name); });

TEST(RobotPosesFile, ReadsEveryWayOfAPoseAndRefusesMistakes) {
    const test::TemporaryFolder folder;
    const auto load = [&](const std::string& text) {
        test::write_text(folder / "poses.yaml", "format: gripscan-robot-poses/1\n" + text);
        return load_robot_poses(folder / "poses.yaml");
    };
    const std::string head = "rig: rig.yaml\nboard: {chessboard: [9, 6], square_mm: 25}\nposes:\n";
    const auto file = load(head +
                           "  - {left: a.png, right: b.png, joints_deg: [0, 0, 0, 0, -90, 30]}\n"
                           "  - {left: a.png, right: b.png, flange: [485, 0, 395, 180, 0, 30]}\n");
    ASSERT_TRUE(file) << file.error().message;
    ASSERT_EQ(file->rows.size(), 2U);
    EXPECT_LT(apart_mm(file->rows[0].T_robot_flange, file->rows[1].T_robot_flange), 1e-6);
    EXPECT_LT(apart_deg(file->rows[0].T_robot_flange, file->rows[1].T_robot_flange), 1e-6);
    EXPECT_EQ(file->rows[0].left, folder.path() / "a.png");
    EXPECT_EQ(file->mounting, Mounting::kBoardOnFlange);
    const auto refusal = [&](const std::string& text) { return load(text).error().message; };
    EXPECT_THAT(refusal(head + "  - {left: a.png, right: b.png}\n"),
                testing::AllOf(testing::HasSubstr("poses.yaml:5"), testing::HasSubstr("flange")));
    EXPECT_THAT(refusal(head + "  - {left: a.png, joints_deg: [0, 0, 0, 0, 0, 0]}\n"),
                testing::HasSubstr("right is missing"));
    EXPECT_THAT(refusal(head + "  - {left: a.png, right: b.png, joints: 3}\n"),
                testing::HasSubstr("unknown key"));
    EXPECT_THAT(refusal("board: {chessboard: [9, 6], square_mm: 25}\nposes: []\n"),
                testing::HasSubstr("one of both"));
}

TEST(AlignmentFile, ComesBackAsItWasWritten) {
    const test::TemporaryFolder folder;
    SeededRandom random(1);
    AlignmentFile file;
    file.T_robot_camera = test::random_pose(random, 2.0);
    file.method = "Park";
    file.views = 12;
    file.sd_mm = 0.25;
    ASSERT_TRUE(save_alignment(folder / "a.yaml", file));
    const auto again = load_alignment(folder / "a.yaml");
    ASSERT_TRUE(again) << again.error().message;
    EXPECT_LT(apart_mm(*again->T_robot_camera, *file.T_robot_camera), 1e-9);
    EXPECT_EQ(again->sd_mm, 0.25);
    EXPECT_EQ(again->views, 12);
    EXPECT_TRUE(load_robot_camera(folder / "a.yaml"));
    file.T_flange_camera = file.T_robot_camera;
    file.T_robot_camera.reset();
    ASSERT_TRUE(save_alignment(folder / "b.yaml", file));
    const auto moving = load_robot_camera(folder / "b.yaml");
    ASSERT_FALSE(moving);
    EXPECT_THAT(moving.error().message, testing::HasSubstr("on the flange"));
}

}  // namespace
}  // namespace gripscan
