// The window on a screen in memory.
#include "ui/shell/app_window.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <cstdlib>
#include <thread>

#include "tests/support/virtual_screen.h"
#include "ui/widgets/button.h"
#include "ui/widgets/draw.h"

namespace gripscan::ui {
namespace {

class Window : public testing::Test {
  protected:
    void SetUp() override {
        ASSERT_NE(screen_, nullptr) << "Xvfb does not start";
        auto made = AppWindow::make({.width_px = 800, .height_px = 500});
        ASSERT_TRUE(made.has_value()) << made.error().message;
        window_ = *std::move(made);
    }
    void TearDown() override { window_.reset(); }

    std::unique_ptr<test::VirtualScreen> screen_ = test::VirtualScreen::make();
    std::unique_ptr<AppWindow> window_;
};

FrameWish one_button(const FrameInput& input) {
    (void)button(input.ui, {20, 20, 120, 36}, {.id = "a", .label = "Capture"});
    return {};
}

TEST_F(Window, OpensDrawsThirtyFramesAndCloses) {
    ASSERT_TRUE(window_->run(one_button, 30).has_value());
    EXPECT_EQ(window_->frames_drawn(), 30U);
    EXPECT_TRUE(window_->widgets().find("a").has_value());
    window_.reset();
    auto again = AppWindow::make({.width_px = 640, .height_px = 400});
    ASSERT_TRUE(again.has_value()) << "a second window after the first";
    ASSERT_TRUE((*again)->run(one_button, 3).has_value());
}

TEST_F(Window, ItsPictureIsWhatThePanelsDrew) {
    std::vector<std::uint8_t> pixels;
    int width = 0;
    const auto frame = [&](const FrameInput& input) {
        fill({100, 50, 40, 30}, {10, 200, 30});
        EXPECT_EQ(input.width_px, 800);
        return FrameWish{};
    };
    ASSERT_TRUE(window_->run(frame, 2).has_value());
    window_->capture_next([&](int w, int h, std::vector<std::uint8_t> rgba) {
        width = w;
        EXPECT_EQ(h, 500);
        pixels = std::move(rgba);
    });
    ASSERT_TRUE(window_->run(frame, 1).has_value());
    ASSERT_EQ(width, 800);
    const auto at = [&](std::size_t x, std::size_t y) { return &pixels[4 * (y * 800 + x)]; };
    EXPECT_EQ(at(120, 60)[1], 200);
    EXPECT_NE(at(120, 90)[1], 200);
}

TEST_F(Window, AFrameClosesItAndTimersAndOtherThreadsWakeIt) {
    int frames = 0;
    const auto frame = [&](const FrameInput&) {
        ++frames;
        // The first frames follow the opening; from then on only the timer and the thread wake it.
        return FrameWish{.redraw_after_s = frames < 10 ? 0.001 : 1e9, .close = frames >= 20};
    };
    std::atomic<bool> stop{false};
    std::thread other([&] {
        while (!stop) {
            AppWindow::request_redraw();
            std::this_thread::sleep_for(std::chrono::milliseconds(2));
        }
    });
    const auto ended = window_->run(frame);
    stop = true;
    other.join();
    ASSERT_TRUE(ended.has_value());
    EXPECT_EQ(frames, 20);
}

TEST_F(Window, StandsStillWhenNothingHappens) {
    std::size_t frames = 0;
    std::thread closer([] {
        std::this_thread::sleep_for(std::chrono::milliseconds(1500));
        AppWindow::request_redraw();
    });
    const auto start = std::chrono::steady_clock::now();
    const auto frame = [&](const FrameInput&) {
        ++frames;
        const bool late =
            std::chrono::steady_clock::now() - start > std::chrono::milliseconds(1400);
        return FrameWish{.close = late};
    };
    ASSERT_TRUE(window_->run(frame).has_value());
    closer.join();
    // The opening brings a few events with a few frames each; then none for more than a second.
    EXPECT_LT(frames, 30U);
}

TEST_F(Window, TheUsersScaleIsAppliedBetweenFrames) {
    float scale = 0.0F;
    bool dark = true;
    const auto frame = [&](const FrameInput& input) {
        scale = input.ui.scale.factor();
        dark = input.ui.theme.dark;
        return FrameWish{};
    };
    ASSERT_TRUE(window_->run(frame, 1).has_value());
    EXPECT_EQ(scale, 1.0F);
    EXPECT_TRUE(dark);
    window_->set_user_scale(2.0F);
    window_->set_theme(ThemeChoice::kLight);
    ASSERT_TRUE(window_->run(frame, 1).has_value());
    EXPECT_EQ(scale, 2.0F);
    EXPECT_FALSE(dark);
    window_->set_user_scale(50.0F);
    ASSERT_TRUE(window_->run(frame, 1).has_value());
    EXPECT_EQ(scale, 4.0F);
}

TEST(WindowWithoutAScreen, SaysSoAndWhatToDo) {
    ::unsetenv("DISPLAY");
    ::unsetenv("WAYLAND_DISPLAY");
    const auto made = AppWindow::make({});
    ASSERT_FALSE(made.has_value());
    EXPECT_EQ(made.error().kind, ErrorKind::kDevice);
    EXPECT_THAT(made.error().message, testing::HasSubstr("DISPLAY"));
}

}  // namespace
}  // namespace gripscan::ui
