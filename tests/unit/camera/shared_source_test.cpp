#include "core/camera/shared_source.h"

#include <gtest/gtest.h>

#include <atomic>
#include <opencv2/core.hpp>
#include <thread>
#include <vector>

namespace gripscan {
namespace {
using namespace std::chrono_literals;

/// Notices when it is asked twice at a time.
class SlowCamera : public StereoSource {
  public:
    Result<StereoFrame> grab(const FrameRequest& request) override {
        if (inside.exchange(true)) overlapped = true;
        std::this_thread::sleep_for(2ms);
        inside = false;
        if (request.capture == 99) return device_error("the camera is gone");
        StereoFrame frame;
        frame.t_s = request.capture;
        return frame;
    }
    std::atomic<bool> inside = false;
    std::atomic<bool> overlapped = false;
};

TEST(SharedSource, OneExposureAtATimeAndEveryOneIsShown) {
    SlowCamera camera;
    std::atomic<int> shown = 0;
    SharedSource shared(camera, [&](const FrameRequest&, const StereoFrame&) { ++shown; });
    {
        std::vector<std::jthread> threads;
        for (int t = 0; t < 4; ++t) {
            threads.emplace_back([&] {
                for (int i = 0; i < 5; ++i) ASSERT_TRUE(shared.grab({i, 1, 0}));
            });
        }
    }
    EXPECT_FALSE(camera.overlapped);
    EXPECT_EQ(shown, 20);
}

TEST(SharedSource, WhoOnlyTriesDoesNotWait) {
    SlowCamera camera;
    std::atomic<bool> tried = false;
    SharedSource* self = nullptr;
    SharedSource shared(camera, [&](const FrameRequest& request, const StereoFrame&) {
        if (request.capture != 0) return;
        // While this exposure is shown, another thread finds the camera in use.
        std::jthread([&] { tried = !self->try_grab({1, 1, 0}).has_value(); }).join();
    });
    self = &shared;
    ASSERT_TRUE(shared.grab({0, 1, 0}));
    EXPECT_TRUE(tried);
    const auto now = shared.try_grab({1, 1, 0});
    ASSERT_TRUE(now.has_value());
    EXPECT_EQ((*now)->t_s, 1.0);
}

TEST(SharedSource, ErrorsAreHandedOnAndNotShown) {
    SlowCamera camera;
    int shown = 0;
    SharedSource shared(camera, [&](const FrameRequest&, const StereoFrame&) { ++shown; });
    const auto frame = shared.grab({99, 1, 0});
    ASSERT_FALSE(frame);
    EXPECT_EQ(frame.error().message, "the camera is gone");
    EXPECT_EQ(shown, 0);
}

}  // namespace
}  // namespace gripscan
