// The live view with a camera that the test holds in its hands.
#include "app/workstation/live_view.h"

#include <gmock/gmock.h>

#include <opencv2/core.hpp>

namespace gripscan::app {
namespace {
using namespace std::chrono_literals;
using testing::HasSubstr;

constexpr int kWidth = 320;
constexpr int kHeight = 240;

StereoRig rectified_rig() {
    StereoRig rig;
    rig.image = {kWidth, kHeight};
    rig.K_left << 400.0, 0.0, 159.5, 0.0, 400.0, 119.5, 0.0, 0.0, 1.0;
    rig.K_right = rig.K_left;
    rig.T_right_left.translation() = Eigen::Vector3d(-0.1, 0.0, 0.0);
    return rig;
}

/// A wall with a fine texture, 40 px of disparity.
StereoFrame wall(double t_s) {
    cv::Mat texture(kHeight, kWidth + 64, CV_8U);
    cv::RNG random(11);
    random.fill(texture, cv::RNG::UNIFORM, 40, 200);
    StereoFrame frame;
    frame.left = texture(cv::Rect(0, 0, kWidth, kHeight)).clone();
    frame.right = texture(cv::Rect(40, 0, kWidth, kHeight)).clone();
    frame.t_s = t_s;
    return frame;
}

class HandCamera : public StereoSource {
  public:
    Result<StereoFrame> grab(const FrameRequest&) override {
        std::this_thread::sleep_for(takes);
        ++grabs;
        if (broken) return device_error("the camera answers no more");
        return wall(0.1 * grabs);
    }
    std::atomic<int> grabs = 0;
    std::atomic<bool> broken = false;
    std::chrono::milliseconds takes{0};
};

struct Bench {
    explicit Bench(double rate_hz) {
        LiveViewSettings settings;
        settings.rate_hz = rate_hz;
        settings.matched_every_s = 0.01;
        auto made = LiveView::make(rectified_rig(), settings, [] {});
        EXPECT_TRUE(made);
        view = std::move(*made);
    }
    ~Bench() { view->stop(); }
    template <typename Done>
    [[nodiscard]] bool until(const Done& done) const {
        for (int i = 0; i < 4000; ++i) {
            if (done()) return true;
            std::this_thread::sleep_for(5ms);
        }
        return false;
    }
    HandCamera camera;
    std::unique_ptr<LiveView> view;
    SharedSource shared{camera, [this](const FrameRequest& request, const StereoFrame& frame) {
                            view->show(request, frame);
                        }};
};

TEST(LiveView, MatchesAPairBesideAndKeepsItsDisparity) {
    Bench bench(20.0);
    bench.view->start(bench.shared);
    ASSERT_TRUE(bench.until([&] { return bench.view->shown().matched != nullptr; }));
    const ui::LiveStereo live = bench.view->shown();
    ASSERT_TRUE(live.matched_facts.row_error_px) << live.matched_facts.why_no_row_error;
    EXPECT_NEAR(*live.matched_facts.row_error_px, 0.0, 0.02);
    ASSERT_TRUE(live.matched_facts.fill) << live.matched_facts.why_no_fill;
    EXPECT_GT(*live.matched_facts.fill, 0.6);
    EXPECT_EQ(live.matched->disparity.size(), live.matched->left.size());
    EXPECT_NEAR(live.matched->disparity.at<float>(kHeight / 2, 200), 40.0, 0.5);
}

TEST(LiveView, MatchesNothingWhileItIsToBeQuiet) {
    Bench bench(50.0);
    bench.view->set_quiet("a capture");
    bench.view->start(bench.shared);
    ASSERT_TRUE(bench.until([&] { return bench.view->shown().number > 5; }));
    EXPECT_EQ(bench.view->shown().matched, nullptr);
    EXPECT_EQ(bench.view->shown().why_not_matched, "a capture");
    bench.view->set_quiet("");
    EXPECT_TRUE(bench.until([&] { return bench.view->shown().matched != nullptr; }));
}

TEST(LiveView, CountsWhatTheCameraDoesNotDeliver) {
    Bench bench(50.0);
    bench.camera.broken = true;
    bench.view->start(bench.shared);
    ASSERT_TRUE(bench.until([&] { return bench.view->shown().lost.not_delivered >= 2; }));
    EXPECT_THAT(bench.view->shown().trouble, HasSubstr("answers no more"));
}

TEST(LiveView, CountsWhatWasDueWhileThePairBeforeWasTaken) {
    Bench bench(20.0);
    bench.camera.takes = 220ms;  // four periods and some
    bench.view->start(bench.shared);
    ASSERT_TRUE(bench.until([&] { return bench.view->shown().number >= 2; }));
    EXPECT_GE(bench.view->shown().lost.late, 4U);
}

TEST(LiveView, CountsWhatWasFollowedByTheNextBeforeAnybodyLooked) {
    Bench bench(5.0);
    for (int i = 0; i < 3; ++i) bench.view->show({i, 1, 0}, wall(i));
    EXPECT_EQ(bench.view->shown().lost.not_shown, 2U);
    bench.view->show({3, 1, 0}, wall(3.0));
    EXPECT_EQ(bench.view->shown().lost.not_shown, 2U) << "the third one was looked at";
    EXPECT_EQ(bench.view->shown().number, 4U);
}

TEST(LiveView, DoesNotCountTheSecondExposureOfACapture) {
    Bench bench(5.0);
    bench.view->show({1, 1, 0}, wall(0.0));
    bench.view->show({1, 1, 1}, wall(0.1));
    EXPECT_EQ(bench.view->shown().number, 1U);
    EXPECT_EQ(bench.view->shown().lost.all(), 0U);
}

}  // namespace
}  // namespace gripscan::app
