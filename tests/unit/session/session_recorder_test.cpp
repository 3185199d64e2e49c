#include "core/session/session_recorder.h"

#include <gmock/gmock.h>

#include <numbers>
#include <opencv2/core.hpp>

#include "core/base/units.h"
#include "core/camera/image_file.h"
#include "tests/support/temporary_folder.h"

namespace gripscan {
namespace {

using testing::HasSubstr;

StereoRig small_rig() {
    StereoRig rig;
    rig.image = {64, 48};
    rig.K_left << 60, 0, 31.5, 0, 60, 23.5, 0, 0, 1;
    rig.K_right = rig.K_left;
    rig.T_right_left.translation().x() = -0.1;
    return rig;
}

TakenCapture capture(int index) {
    TakenCapture taken;
    taken.index = index;
    taken.commanded_rad = index * rad_from_deg(10.0);
    taken.before.joints_rad = {0.1, 0.2, 0.3, 0.4, 0.5, taken.commanded_rad - 1.0};
    taken.after = taken.before;
    taken.after.joints_rad[5] += 1e-4;
    taken.before.T_world_tool.translation() = Eigen::Vector3d(0.5, -0.02, 0.48);
    taken.frame.left = cv::Mat(48, 64, CV_8UC1);
    taken.frame.right = cv::Mat(48, 64, CV_8UC1);
    cv::randu(taken.frame.left, 0, 255);
    cv::randu(taken.frame.right, 0, 255);
    taken.frame.t_s = 0.5 * index;
    return taken;
}

TEST(SessionRecorder, LeavesAValidSessionAfterEveryCapture) {
    const test::TemporaryFolder folder;
    SessionSpec spec;
    spec.step_deg = 10.0;
    spec.region = Box{{-0.1, -0.1, 0.5}, {0.1, 0.1, 0.8}};
    auto recorder = SessionRecorder::create(folder / "s", spec, small_rig());
    ASSERT_TRUE(recorder) << recorder.error().message;
    for (int k = 0; k < 4; ++k) {
        const TakenCapture taken = capture(k);
        const Status stored = recorder->store(taken);
        ASSERT_TRUE(stored) << stored.error().message;
        if (k == 0) continue;  // one capture is no turn yet
        const auto session = open_session(folder / "s");
        ASSERT_TRUE(session) << session.error().message;
        ASSERT_TRUE(check_session_files(*session, {}, for_each_in_order));
        const CaptureRow& row = session->table.rows.at(static_cast<std::size_t>(k));
        EXPECT_EQ(row.commanded_deg, 10.0 * k) << "tidy numbers";
        EXPECT_NEAR(*row.joints_deg[5], deg_from_rad(taken.before.joints_rad[5]), 1e-9);
        EXPECT_NEAR(*row.j6_after_deg, deg_from_rad(taken.after.joints_rad[5]), 1e-9);
        EXPECT_EQ(row.tool[0], 500.0);
        const auto left = load_grey_image(session->file(row.left));
        ASSERT_TRUE(left);
        EXPECT_EQ(cv::norm(*left, taken.frame.left, cv::NORM_INF), 0.0) << "images are lossless";
    }
}

TEST(SessionRecorder, NeverOverwrites) {
    const test::TemporaryFolder folder;
    test::write_text(folder / "s/captures.csv", "precious");
    const auto recorder = SessionRecorder::create(folder / "s", {}, small_rig());
    ASSERT_FALSE(recorder);
    EXPECT_THAT(recorder.error().message, HasSubstr("never overwritten"));
    EXPECT_EQ(test::read_text(folder / "s/captures.csv"), "precious");
    test::write_text(folder / "f", "precious");
    EXPECT_FALSE(SessionRecorder::create(folder / "f", {}, small_rig()));
}

}  // namespace
}  // namespace gripscan
