#include "ui/panels/stereo_panel.h"

#include <gtest/gtest.h>

#include "tests/support/sample_scene.h"
#include "tests/support/ui_driver.h"

namespace gripscan::ui {
namespace {

class StereoPanel : public testing::Test {
  protected:
    StereoPanel()
        : driver_(312, 578, [this](const Ui& ui) {
              draw_stereo_panel(ui, {0, 0, 312, 578}, scene_.snapshot, nullptr, local_, requests_);
          }) {}

    test::SampleScene scene_ = test::growing_scene(1, 2000);
    StereoPanelState local_;
    Requests requests_;
    test::UiDriver driver_;
};

TEST_F(StereoPanel, SwitchesLiveImages) {
    ASSERT_TRUE(driver_.click("stereo.live"));
    ASSERT_EQ(requests_.size(), 1U);
    EXPECT_TRUE(std::get<request::LiveView>(requests_[0]).on);
    scene_.snapshot.live.on = true;
    requests_.clear();
    ASSERT_TRUE(driver_.click("stereo.live"));
    EXPECT_FALSE(std::get<request::LiveView>(requests_.at(0)).on);
}

TEST_F(StereoPanel, SaysWhyThereAreNoLiveImages) {
    scene_.snapshot.live.why_off = "the camera is used by the capture";
    driver_.frame();
    EXPECT_EQ(driver_.log().find("stereo.why_not_live")->label,
              "not live: the camera is used by the capture");
    scene_.snapshot.session->recorded = true;
    driver_.frame();
    EXPECT_EQ(driver_.log().find("stereo.live")->reason, "a recording has no camera");
}

TEST_F(StereoPanel, ShowsTheDisparityWhereThereIsOne) {
    driver_.frame();
    EXPECT_FALSE(driver_.log().find("stereo.left_disparity")->enabled);
    scene_.snapshot.captures.back().picture = test::sample_picture();
    ASSERT_TRUE(driver_.click("stereo.left_disparity"));
    driver_.frame();
    EXPECT_TRUE(driver_.log().find("stereo.disparity"));
    EXPECT_FALSE(driver_.log().find("stereo.right"));
    ASSERT_TRUE(driver_.click("stereo.left_right"));
    driver_.frame();
    EXPECT_TRUE(driver_.log().find("stereo.right"));
}

TEST_F(StereoPanel, ZoomsBothImagesWhileTheyAreLinked) {
    scene_.snapshot.captures.back().picture = test::sample_picture();
    const auto wheel = [&] {
        ASSERT_TRUE(driver_.hover("stereo.left"));
        ImGui::GetIO().MouseWheel = 3.0F;
        driver_.frame();
        ImGui::GetIO().MouseWheel = 0.0F;
        driver_.frame();
    };
    wheel();
    EXPECT_GT(local_.first.zoom, 1.5);
    EXPECT_EQ(local_.first, local_.second);
    ASSERT_TRUE(driver_.click("stereo.link"));
    EXPECT_FALSE(local_.linked);
    wheel();
    EXPECT_GT(local_.first.zoom, local_.second.zoom);
}

TEST_F(StereoPanel, TheRulerFollowsTheMouse) {
    scene_.snapshot.captures.back().picture = test::sample_picture();
    ASSERT_TRUE(driver_.hover("stereo.left"));
    EXPECT_NEAR(local_.ruler, 0.5, 0.02);
}

}  // namespace
}  // namespace gripscan::ui
