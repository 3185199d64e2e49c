// When a picture is kept: after settling, of a scene at rest, with the joints read around it.
#include "core/procedure/exposure.h"

#include <gmock/gmock.h>

#include <chrono>
#include <opencv2/core.hpp>
#include <thread>

#include "core/base/units.h"
#include "core/procedure/region_stillness.h"
#include "tests/unit/procedure/cell_bench.h"

namespace gripscan {
namespace {

using testing::HasSubstr;
using Clock = std::chrono::steady_clock;

/// A camera that notes when and for what it was asked; its pictures carry their number.
struct NotingCamera : StereoSource {
    Result<StereoFrame> grab(const FrameRequest& request) override {
        if (fails_at == static_cast<int>(requests.size())) {
            return device_error("the camera was unplugged");
        }
        requests.push_back(request);
        times.push_back(Clock::now());
        if (before_each) before_each();
        StereoFrame frame;
        frame.left = cv::Mat(1, 1, CV_8U, cv::Scalar(static_cast<double>(requests.size())));
        frame.right = frame.left;
        return frame;
    }
    std::vector<FrameRequest> requests;
    std::vector<Clock::time_point> times;
    std::function<void()> before_each;
    int fails_at = -1;
};

struct Stage {
    NotingCamera camera;
    test::BenchRobot robot{JointAngles{}};
    ExposureSettings settings{.settle_s = 0.0, .tries = 4, .pause_s = 0.0};
    int moving_pairs = 0;  ///< so many pairs of exposures differ, then they agree

    Result<Exposure> expose(RobotLink* link, std::stop_token stop = {}) {
        const StillnessTest differs = [this](const StereoFrame&,
                                             const StereoFrame&) -> std::optional<std::string> {
            if (moving_pairs-- > 0) return "it trembles by 0.4 px";
            return std::nullopt;
        };
        return gripscan::expose(link, camera, {ShotPurpose::kTurn, 7, 2, 0.0}, differs, settings,
                                std::move(stop));
    }
};

int number_of(const StereoFrame& frame) {
    return frame.left.at<unsigned char>(0, 0);
}

TEST(Exposure, KeepsTheSecondOfTwoThatAgree) {
    Stage stage;
    const auto exposure = stage.expose(&stage.robot);
    ASSERT_TRUE(exposure) << exposure.error().message;
    ASSERT_EQ(stage.camera.requests.size(), 2U);
    EXPECT_EQ(number_of(exposure->frame), 2);
    // The kept one is always asked for by the same numbers: a resumed run sees the same picture.
    EXPECT_EQ(stage.camera.requests[1].capture, 7);
    EXPECT_EQ(stage.camera.requests[1].attempt, 2);
    EXPECT_EQ(stage.camera.requests[1].exposure, 0);
    EXPECT_NE(stage.camera.requests[0].exposure, 0);
}

TEST(Exposure, NothingIsExposedBeforeTheArmHasSettled) {
    Stage stage;
    stage.settings.settle_s = 0.15;
    const auto start = Clock::now();
    ASSERT_TRUE(stage.expose(&stage.robot));
    EXPECT_GE(std::chrono::duration<double>(stage.camera.times.front() - start).count(), 0.15);
}

TEST(Exposure, ASceneThatMovesIsLookedAtAgainUntilItRests) {
    Stage stage;
    stage.settings.pause_s = 0.05;
    stage.moving_pairs = 2;
    const auto exposure = stage.expose(&stage.robot);
    ASSERT_TRUE(exposure) << exposure.error().message;
    EXPECT_EQ(stage.camera.requests.size(), 6U);
    EXPECT_EQ(number_of(exposure->frame), 6) << "a picture of the moving scene was kept";
    for (const std::size_t pair : {2U, 4U}) {
        EXPECT_GE(
            std::chrono::duration<double>(stage.camera.times[pair] - stage.camera.times[pair - 1])
                .count(),
            0.05);
    }
}

TEST(Exposure, ASceneThatNeverRestsIsAnErrorThatSaysWhatMoved) {
    Stage stage;
    stage.moving_pairs = 1000;
    const auto exposure = stage.expose(&stage.robot);
    ASSERT_FALSE(exposure);
    EXPECT_EQ(exposure.error().kind, ErrorKind::kDevice);
    EXPECT_THAT(exposure.error().message, HasSubstr("trembles by 0.4 px"));
    EXPECT_THAT(exposure.error().message, HasSubstr("4 pairs"));
    EXPECT_EQ(stage.camera.requests.size(), 8U);
}

TEST(Exposure, TheJointsAreReadBeforeAndAfterTheKeptPicture) {
    Stage stage;
    stage.robot.joints_rad[5] = 0.1;
    int grabbed = 0;
    // Moves a little while each picture is taken.
    stage.camera.before_each = [&] { stage.robot.joints_rad[5] = 0.1 + 0.01 * ++grabbed; };
    const auto exposure = stage.expose(&stage.robot);
    ASSERT_TRUE(exposure);
    ASSERT_TRUE(exposure->before && exposure->joint6_after_rad);
    EXPECT_DOUBLE_EQ(exposure->before->joints_rad[5], 0.11) << "after the first picture";
    EXPECT_DOUBLE_EQ(*exposure->joint6_after_rad, 0.12) << "after the second";
}

TEST(Exposure, WithoutARobotThereAreNoJoints) {
    Stage stage;
    const auto exposure = stage.expose(nullptr);
    ASSERT_TRUE(exposure);
    EXPECT_FALSE(exposure->before);
    EXPECT_FALSE(exposure->joint6_after_rad);
}

TEST(Exposure, CameraFailuresArePassedOn) {
    for (const int at : {0, 1}) {
        Stage stage;
        stage.camera.fails_at = at;
        const auto exposure = stage.expose(&stage.robot);
        ASSERT_FALSE(exposure);
        EXPECT_THAT(exposure.error().message, HasSubstr("unplugged"));
    }
}

TEST(Exposure, EndsAtOnceWhenStopped) {
    Stage stage;
    stage.settings.settle_s = 1000.0;
    std::stop_source source;
    const std::jthread stopper([&] {
        std::this_thread::sleep_for(std::chrono::milliseconds(50));
        source.request_stop();
    });
    const auto exposure = stage.expose(&stage.robot, source.get_token());
    ASSERT_FALSE(exposure);
    EXPECT_EQ(exposure.error().kind, ErrorKind::kCancelled);
    EXPECT_TRUE(stage.camera.requests.empty());
}

/// On rendered pictures of a standing arm, and of one that turns a little between the two.
TEST(RegionStillness, TellsNoiseFromMotion) {
    test::CellBench bench(3);
    const auto differs = region_stillness(bench.layout.rig, bench.region);
    ASSERT_TRUE(differs) << differs.error().message;
    const StereoFrame first = bench.picture({1, 1, 1});
    const auto standing = (*differs)(first, bench.picture({1, 1, 0}));
    EXPECT_FALSE(standing) << *standing;
    bench.robot.joints_rad[5] += rad_from_deg(0.3);
    const auto moving = (*differs)(first, bench.picture({1, 1, 0}));
    ASSERT_TRUE(moving);
    EXPECT_THAT(*moving, HasSubstr("px"));
}

}  // namespace
}  // namespace gripscan
