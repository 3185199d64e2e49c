#include "ui/panels/view3d_panel.h"

#include <gtest/gtest.h>

#include "tests/support/egl_context.h"
#include "tests/support/sample_scene.h"
#include "tests/support/ui_driver.h"
#include "ui/imgui_compat.h"
#include "ui/panels/view3d_gestures.h"

namespace gripscan::ui {
namespace {

constexpr int kWidth = 900;
constexpr int kHeight = 578;
const Rect kRect{0, 0, kWidth, kHeight};

/// The panel alone on a screen.
class View3dPanel : public testing::Test {
  protected:
    void SetUp() override {
        ASSERT_NE(context_, nullptr);
        auto made = View3d::make();
        ASSERT_TRUE(made.has_value()) << made.error().message;
        view_ = *std::move(made);
        driver_ = std::make_unique<test::UiDriver>(kWidth, kHeight, [this](const Ui& ui) {
            view_->draw(ui, kRect, scene_.snapshot, local_, requests_);
        });
    }

    void show(test::SampleScene scene) {
        scene_ = std::move(scene);
        driver_->mouse(450.0F, 300.0F);
        driver_->frame();
        requests_.clear();
    }

    void drag(ImGuiMouseButton button, float dx, float dy) {
        driver_->press(button, true);
        driver_->mouse(450.0F + dx, 300.0F + dy);
        driver_->press(button, false);
        driver_->frame();
    }

    void press_key(char key, bool ctrl = false) {
        ImGuiIO& io = ImGui::GetIO();
        io.KeyCtrl = ctrl;
        io.KeysDown[static_cast<int>(key)] = true;
        // As a keyboard does: what is held with Ctrl types nothing.
        if (!ctrl) io.AddInputCharacter(static_cast<unsigned char>(key));
        driver_->frame();
        io.KeysDown[static_cast<int>(key)] = false;
        io.KeyCtrl = false;
        driver_->frame();
    }

    std::vector<TemplateFilter> filters() const {
        std::vector<TemplateFilter> found;
        for (const Request& request : requests_) {
            if (const auto* set = std::get_if<request::SetFilter>(&request)) {
                found.push_back(set->filter);
            }
        }
        return found;
    }

    std::unique_ptr<test::EglContext> context_ = test::EglContext::make();
    std::unique_ptr<View3d> view_;
    test::SampleScene scene_ = test::empty_scene();
    View3dState local_;
    Requests requests_;
    std::unique_ptr<test::UiDriver> driver_;
};

void expect_same(const OrbitCamera& a, const OrbitCamera& b) {
    EXPECT_NEAR((a.pivot_m - b.pivot_m).norm(), 0.0, 1e-9);
    EXPECT_NEAR(a.distance_m, b.distance_m, 1e-9);
    EXPECT_NEAR(a.yaw_rad, b.yaw_rad, 1e-9);
    EXPECT_NEAR(a.pitch_rad, b.pitch_rad, 1e-9);
}

TEST_F(View3dPanel, DragsMoveTheCameraAsTheGesturesSay) {
    show(test::growing_scene(3, 6000));
    const Viewport viewport = viewport_of(kRect);
    OrbitCamera before = local_.camera;
    drag(ImGuiMouseButton_Left, 40.0F, -25.0F);
    expect_same(local_.camera, orbited(before, 40.0, -25.0, viewport));

    for (const auto button : {ImGuiMouseButton_Right, ImGuiMouseButton_Middle}) {
        driver_->mouse(450.0F, 300.0F);
        before = local_.camera;
        drag(button, -30.0F, 12.0F);
        expect_same(local_.camera, panned(before, -30.0, 12.0, viewport));
    }
    driver_->mouse(450.0F, 300.0F);
    before = local_.camera;
    ImGui::GetIO().KeyShift = true;
    drag(ImGuiMouseButton_Left, 10.0F, 10.0F);
    ImGui::GetIO().KeyShift = false;
    expect_same(local_.camera, panned(before, 10.0, 10.0, viewport));
}

TEST_F(View3dPanel, PresetsGiveTheButtonsOtherMeanings) {
    auto scene = test::growing_scene(2, 6000);
    scene.snapshot.preferences.navigation = "CAD";
    show(std::move(scene));
    OrbitCamera before = local_.camera;
    drag(ImGuiMouseButton_Left, 40.0F, 10.0F);
    expect_same(local_.camera, before);
    driver_->mouse(450.0F, 300.0F);
    drag(ImGuiMouseButton_Middle, 40.0F, 10.0F);
    expect_same(local_.camera, orbited(before, 40.0, 10.0, viewport_of(kRect)));
}

TEST_F(View3dPanel, TheWheelComesNearerToWhatIsUnderTheCursor) {
    show(test::growing_scene(3, 20000));
    ASSERT_TRUE(local_.cursor) << "the part lies in the middle";
    const Eigen::Vector3d under = local_.cursor->point_m;
    const auto before = project(local_.camera, viewport_of(kRect), under);
    const double distance = local_.camera.distance_m;
    ImGui::GetIO().MouseWheel = 2.0F;
    driver_->frame();
    ImGui::GetIO().MouseWheel = 0.0F;
    EXPECT_LT(local_.camera.distance_m, distance);
    const auto after = project(local_.camera, viewport_of(kRect), under);
    EXPECT_NEAR((*after - *before).norm(), 0.0, 1e-6) << "it keeps its pixel";
}

TEST_F(View3dPanel, ADoubleClickMakesThePointThePivot) {
    show(test::growing_scene(3, 20000));
    driver_->mouse(440.0F, 290.0F);
    ASSERT_TRUE(local_.cursor);
    const Eigen::Vector3d under = local_.cursor->point_m;
    for (int i = 0; i < 2; ++i) {
        driver_->press(ImGuiMouseButton_Left, true);
        driver_->press(ImGuiMouseButton_Left, false);
    }
    EXPECT_NEAR((local_.camera.pivot_m - under).norm(), 0.0, 1e-9);
    EXPECT_FALSE(view_->complete()) << "the cross is shown for a while";
}

TEST_F(View3dPanel, KeysChooseTheView) {
    show(test::growing_scene(2, 6000));
    press_key('1', true);
    EXPECT_EQ(local_.camera.yaw_rad, 0.0);
    press_key('7', true);
    EXPECT_NEAR(local_.camera.pitch_rad, 0.5 * M_PI, 1e-12);
    press_key('X');
    EXPECT_NEAR(local_.camera.R_world_view().col(2).dot(test::scene_axis().direction), 1.0, 1e-9);
    press_key('V');
    EXPECT_NEAR(local_.camera.eye_m().norm(), 0.0, 1e-9);
    press_key('F');
    EXPECT_GT(local_.camera.eye_m().norm(), 0.1);
    scene_.snapshot.dialog = Dialog::kSettings;
    const OrbitCamera before = local_.camera;
    press_key('V');
    expect_same(local_.camera, before);
}

TEST_F(View3dPanel, TwoClicksMeasure) {
    show(test::growing_scene(3, 40000));
    ASSERT_TRUE(driver_->click("view3d.measure"));
    EXPECT_TRUE(local_.measuring.on);
    for (const float x : {430.0F, 470.0F}) {
        driver_->mouse(x, 300.0F);
        driver_->press(ImGuiMouseButton_Left, true);
        driver_->press(ImGuiMouseButton_Left, false);
    }
    ASSERT_EQ(local_.measuring.points_m.size(), 2U);
    const auto px = project(local_.camera, viewport_of(kRect), local_.measuring.points_m[0]);
    EXPECT_NEAR((*px - Eigen::Vector2d(430.0, 300.0)).norm(), 0.0, 8.0) << "within the pick radius";
    EXPECT_TRUE(driver_->log().find("view3d.measured"));
    driver_->key(ImGuiKey_Escape);
    EXPECT_FALSE(local_.measuring.on);
}

TEST_F(View3dPanel, ADragIsNoClick) {
    show(test::growing_scene(3, 20000));
    local_.measuring.on = true;
    drag(ImGuiMouseButton_Left, 30.0F, 0.0F);
    EXPECT_TRUE(local_.measuring.points_m.empty());
}

TEST_F(View3dPanel, AHandleOfTheCuboidDragsItsFace) {
    auto scene = test::template_scene(20000);
    scene.snapshot.filter.crop = Box{{-0.04, -0.06, 0.66}, {0.06, 0.06, 0.74}};
    show(std::move(scene));
    const Box box = *scene_.snapshot.filter.crop;
    const auto handles = box_handles(box, local_.camera, viewport_of(kRect));
    const BoxHandle& handle = handles.back();
    driver_->mouse(static_cast<float>(handle.at_px.x()), static_cast<float>(handle.at_px.y()));
    driver_->press(ImGuiMouseButton_Left, true);
    requests_.clear();
    const OrbitCamera before = local_.camera;
    const Eigen::Vector2d to = handle.at_px + Eigen::Vector2d(25.0, -10.0);
    driver_->mouse(static_cast<float>(to.x()), static_cast<float>(to.y()));
    driver_->press(ImGuiMouseButton_Left, false);
    ASSERT_FALSE(filters().empty());
    const TemplateFilter set = filters().back();
    ASSERT_TRUE(set.crop);
    EXPECT_EQ(set.min_seen, 4) << "the rest of the filter stays";
    // The mouse has whole pixels: at the pivot one is about 0.4 mm.
    const Box expected =
        dragged_box({box, handle.face, handle.at_px}, to, before, viewport_of(kRect));
    EXPECT_NEAR((set.crop->min_m - expected.min_m).norm(), 0.0, 1e-3);
    EXPECT_NEAR((set.crop->max_m - expected.max_m).norm(), 0.0, 1e-3);
    EXPECT_NE(*set.crop, box);
    expect_same(local_.camera, before);
}

TEST_F(View3dPanel, BeforeTheFirstViewTheRegistrationAreaIsDraggedForTheNextSession) {
    auto scene = test::growing_scene(2, 6000);
    scene.snapshot.captures.clear();
    *scene.state = ProcedureState{};
    scene.snapshot.cell.file = "/cells/cell.yaml";
    show(std::move(scene));
    const Box region = *scene_.snapshot.cell.region;
    ASSERT_TRUE(driver_->click("view3d.crop"));
    ASSERT_TRUE(local_.edit_region);
    const BoxHandle handle = box_handles(region, local_.camera, viewport_of(kRect)).back();
    driver_->mouse(static_cast<float>(handle.at_px.x()), static_cast<float>(handle.at_px.y()));
    driver_->press(ImGuiMouseButton_Left, true);
    requests_.clear();
    const Eigen::Vector2d to = handle.at_px + Eigen::Vector2d(25.0, -10.0);
    driver_->mouse(static_cast<float>(to.x()), static_cast<float>(to.y()));
    driver_->press(ImGuiMouseButton_Left, false);
    EXPECT_TRUE(filters().empty()) << "it is no crop";
    ASSERT_FALSE(requests_.empty());
    const auto* set = std::get_if<request::SetRegion>(&requests_.back());
    ASSERT_NE(set, nullptr);
    ASSERT_TRUE(set->region);
    const Box expected =
        dragged_box({region, handle.face, handle.at_px}, to, local_.camera, viewport_of(kRect));
    EXPECT_NEAR((set->region->min_m - expected.min_m).norm(), 0.0, 1e-3);
    EXPECT_NEAR((set->region->max_m - expected.max_m).norm(), 0.0, 1e-3);
    EXPECT_NE(*set->region, region);
}

TEST_F(View3dPanel, TheRegistrationAreaCannotBeDraggedOnceAViewIsTaken) {
    show(test::growing_scene(2, 6000));
    scene_.snapshot.cell.file = "/cells/cell.yaml";
    driver_->frame();
    const auto handles =
        box_handles(*scene_.snapshot.cell.region, local_.camera, viewport_of(kRect));
    driver_->mouse(static_cast<float>(handles.back().at_px.x()),
                   static_cast<float>(handles.back().at_px.y()));
    driver_->press(ImGuiMouseButton_Left, true);
    driver_->mouse(480.0F, 320.0F);
    driver_->press(ImGuiMouseButton_Left, false);
    EXPECT_TRUE(filters().empty());
    const auto crop = driver_->log().find("view3d.crop");
    ASSERT_TRUE(crop);
    EXPECT_FALSE(crop->enabled);
    EXPECT_NE(crop->reason.find("first view is taken"), std::string::npos);
}

TEST_F(View3dPanel, ToolsThatNeedCloudsSayWhyTheyAreOff) {
    show(test::empty_scene());
    for (const auto* id : {"view3d.measure", "view3d.side_by_side", "view3d.along_axis"}) {
        const auto tool = driver_->log().find(id);
        ASSERT_TRUE(tool) << id;
        EXPECT_FALSE(tool->enabled) << id;
        EXPECT_FALSE(tool->reason.empty()) << id;
    }
    EXPECT_TRUE(driver_->log().find("view3d.eye_dome")->enabled);
}

TEST_F(View3dPanel, TheMenuChoosesTheColouring) {
    show(test::growing_scene(3, 6000));
    ASSERT_TRUE(driver_->click("view3d.colour"));
    driver_->frame();
    const auto seen = driver_->log().find("view3d.colour.seen");
    ASSERT_TRUE(seen);
    EXPECT_FALSE(seen->enabled);
    ASSERT_TRUE(driver_->click("view3d.colour.depth"));
    driver_->frame();
    EXPECT_EQ(local_.colour_by, ColourBy::kDepth);
    EXPECT_FALSE(driver_->log().find("view3d.colour.depth")) << "the list is closed";
    EXPECT_TRUE(driver_->log().find("view3d.range_from")) << "its range can be typed";
}

TEST_F(View3dPanel, OfARejectedStepTheSecondCloudCanBeMoved) {
    show(test::rejected_scene(4, 0.25, 8000));
    ASSERT_TRUE(driver_->click("view3d.before"));
    EXPECT_EQ(local_.wish.pair_pose, PairPose::kBefore);
    ASSERT_TRUE(driver_->click("view3d.at_robot"));
    EXPECT_EQ(local_.wish.pair_pose, PairPose::kRobot);
}

TEST_F(View3dPanel, AChoiceBetweenViewsEndsWhenAnotherStepIsChosen) {
    show(test::growing_scene(4, 6000));
    local_.wish.pair = true;
    driver_->frame();
    EXPECT_TRUE(local_.wish.pair.has_value());
    scene_.snapshot.follows_last = false;
    scene_.snapshot.selected_row = 1;
    driver_->frame();
    EXPECT_FALSE(local_.wish.pair.has_value());
}

TEST_F(View3dPanel, SizeAndScreenshotAreButtons) {
    show(test::growing_scene(1, 4000));
    ASSERT_TRUE(driver_->click("view3d.larger"));
    EXPECT_EQ(local_.point_size_px, 3.0F);
    ASSERT_TRUE(driver_->click("view3d.smaller"));
    EXPECT_EQ(local_.point_size_px, 2.0F);
    ASSERT_TRUE(driver_->click("view3d.screenshot"));
    ASSERT_EQ(requests_.size(), 1U);
    const auto* picture = std::get_if<request::Screenshot>(&requests_[0]);
    ASSERT_NE(picture, nullptr);
    EXPECT_TRUE(picture->view_only);
}

TEST_F(View3dPanel, NeedsNoFrameOnceEveryPointIsDrawn) {
    show(test::growing_scene(3, 6000));
    for (int i = 0; i < 5 && !view_->complete(); ++i) driver_->frame();
    EXPECT_TRUE(view_->complete());
}

}  // namespace
}  // namespace gripscan::ui
