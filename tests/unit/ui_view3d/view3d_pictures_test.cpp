#include <gtest/gtest.h>

#include "tests/render/screen_picture.h"
#include "tests/support/egl_context.h"
#include "tests/support/sample_scene.h"
#include "ui/panels/stereo_panel.h"
#include "ui/panels/view3d_panel.h"

namespace gripscan::ui {
namespace {

/// Pictures of the panels in their states, small enough for the repository.
class PanelPictures : public testing::Test {
  protected:
    void SetUp() override { ASSERT_NE(context_, nullptr); }

    void expect_view(const std::string& name, const test::SampleScene& scene, View3dState local,
                     ThemeChoice theme = ThemeChoice::kDark, float factor = 1.0F) {
        const auto view = View3d::make();
        ASSERT_TRUE(view.has_value());
        const int width = static_cast<int>(900.0F * factor);
        const int height = static_cast<int>(578.0F * factor);
        Requests requests;
        const auto picture =
            test::screen_picture(width, height, Scale(factor), theme, [&](const Ui& ui) {
                (*view)->draw(ui, {0, 0, width, height}, scene.snapshot, local, requests);
            });
        EXPECT_TRUE((*view)->complete()) << "three frames have to be enough for these clouds";
        test::expect_golden(picture, "view3d-" + name);
    }

    void expect_stereo(const std::string& name, const test::SampleScene& scene,
                       StereoPanelState local, ThemeChoice theme = ThemeChoice::kDark) {
        StereoTextures textures;
        Requests requests;
        const auto picture = test::screen_picture(312, 578, Scale(), theme, [&](const Ui& ui) {
            draw_stereo_panel(ui, {0, 0, 312, 578}, scene.snapshot, &textures, local, requests);
        });
        test::expect_golden(picture, "stereo-" + name);
    }

    std::unique_ptr<test::EglContext> context_ = test::EglContext::make();
};

TEST_F(PanelPictures, OfAnEmptyViewSayWhatToDo) {
    expect_view("empty-dark", test::empty_scene(), {});
    expect_view("empty-light", test::empty_scene(), {}, ThemeChoice::kLight);
}

TEST_F(PanelPictures, OfTheGrowingCloudLookAsApproved) {
    expect_view("running-dark", test::growing_scene(14, 60000), {});
}

TEST_F(PanelPictures, OfTheGrowingCloudInTheLightThemeAt200PercentLookAsApproved) {
    expect_view("running-light-200", test::growing_scene(14, 60000), {}, ThemeChoice::kLight, 2.0F);
}

TEST_F(PanelPictures, OfTheTwoCloudsOfARejectedStepLookAsApproved) {
    expect_view("rejected-dark", test::rejected_scene(6, 0.25, 150000), {});
}

TEST_F(PanelPictures, SideBySideLookAsApproved) {
    View3dState local;
    local.side_by_side = true;
    expect_view("side-by-side-dark", test::rejected_scene(6, 0.25, 150000), local);
}

TEST_F(PanelPictures, OfTheTemplateWithItsCuboidLookAsApproved) {
    auto scene = test::template_scene(150000);
    scene.snapshot.filter.crop = Box{{-0.04, -0.055, 0.655}, {0.055, 0.08, 0.745}};
    expect_view("template-dark", scene, {});
}

TEST_F(PanelPictures, OfAMeasurementLookAsApproved) {
    View3dState local;
    local.measuring = {true, {{-0.03, -0.047, 0.68}, {0.03, -0.047, 0.72}}};
    expect_view("measuring-light", test::growing_scene(14, 60000), local, ThemeChoice::kLight);
}

TEST_F(PanelPictures, ForTheReportHaveACaptionAndNoTools) {
    View3dState local;
    local.photograph = true;
    expect_view("photograph-light", test::growing_scene(14, 60000), local, ThemeChoice::kLight);
}

TEST_F(PanelPictures, OfStereoImagesLookAsApproved) {
    auto scene = test::growing_scene(1, 2000);
    scene.snapshot.live.picture = test::sample_picture();
    scene.snapshot.live.on = true;
    scene.snapshot.live.rate_hz = 14.9;
    scene.snapshot.live.number = 900;
    scene.snapshot.live.lost.late = 2;
    scene.snapshot.live.matched = scene.snapshot.live.picture;
    scene.snapshot.live.matched_facts.fill = 0.93;
    scene.snapshot.live.matched_facts.row_error_px = 0.08;
    expect_stereo("live-dark", scene, {});
    scene.snapshot.live.trouble = "the camera answers no more";
    StereoPanelState local;
    local.disparity = true;
    expect_stereo("trouble-light", scene, local, ThemeChoice::kLight);
    expect_stereo("empty-dark", test::empty_scene(), {});
}

}  // namespace
}  // namespace gripscan::ui
