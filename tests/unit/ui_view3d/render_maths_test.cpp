#include <gtest/gtest.h>

#include <cmath>

#include "core/base/seeded_random.h"
#include "ui/render/box_handles.h"
#include "ui/render/picture_crop.h"
#include "ui/render/silhouette.h"

namespace gripscan::ui {
namespace {

const Viewport kView{900.0, 578.0};
const Box kBox{{-0.1, -0.05, 0.6}, {0.1, 0.05, 0.8}};

OrbitCamera camera() {
    OrbitCamera camera;
    camera.yaw_rad = 0.5;
    camera.pitch_rad = 0.3;
    return fitted(camera, kBox, kView);
}

TEST(BoxHandles, StandInTheMiddleOfTheFacesHalfOfThemBehind) {
    const auto handles = box_handles(kBox, camera(), kView);
    ASSERT_EQ(handles.size(), 6U);
    EXPECT_EQ(
        std::count_if(handles.begin(), handles.end(), [](const BoxHandle& h) { return h.behind; }),
        3);
    for (const BoxHandle& handle : handles) {
        EXPECT_NEAR((*project(camera(), kView, handle.centre_m) - handle.at_px).norm(), 0.0, 1e-9);
        EXPECT_EQ(handle_at(handles, handle.at_px, 5.0), handle.face);
    }
    EXPECT_EQ(handle_at(handles, {5.0, 5.0}, 5.0), std::nullopt);
}

TEST(BoxHandles, ADraggedFaceStaysUnderTheMouse) {
    for (const BoxHandle& handle : box_handles(kBox, camera(), kView)) {
        // Where the middle of the face would be 20 mm further out is where the mouse goes.
        const double out = handle.face.upper ? 0.02 : -0.02;
        const Eigen::Vector3d target =
            handle.centre_m + out * Eigen::Vector3d::Unit(handle.face.axis);
        const Box box = dragged_box({kBox, handle.face, handle.at_px},
                                    *project(camera(), kView, target), camera(), kView);
        const double moved = handle.face.upper
                                 ? box.max_m(handle.face.axis) - kBox.max_m(handle.face.axis)
                                 : box.min_m(handle.face.axis) - kBox.min_m(handle.face.axis);
        EXPECT_NEAR(moved, out, 1e-6);
        Box others = box;
        (handle.face.upper ? others.max_m : others.min_m)(handle.face.axis) -= moved;
        EXPECT_LT((others.min_m - kBox.min_m).norm() + (others.max_m - kBox.max_m).norm(), 1e-9)
            << "the other faces stay";
    }
}

TEST(BoxHandles, ADragNeverTurnsTheBoxInsideOut) {
    const auto handles = box_handles(kBox, camera(), kView);
    for (const BoxHandle& handle : handles) {
        for (const auto& to : {Eigen::Vector2d(-5000, 30), Eigen::Vector2d(5000, 700)}) {
            EXPECT_TRUE(
                dragged_box({kBox, handle.face, handle.at_px}, to, camera(), kView).valid());
        }
    }
}

std::vector<Eigen::Vector3f> ball(std::size_t count, const Eigen::Vector3f& centre, float radius) {
    SeededRandom random(5);
    std::vector<Eigen::Vector3f> points;
    for (std::size_t i = 0; i < count; ++i) {
        const Eigen::Vector3f n(static_cast<float>(random.normal()),
                                static_cast<float>(random.normal()),
                                static_cast<float>(random.normal()));
        points.push_back(centre + radius * n.normalized());
    }
    return points;
}

TEST(Silhouette, OfABallIsACircleAroundIt) {
    const OrbitCamera view = camera();
    const auto points = ball(20000, view.pivot_m.cast<float>(), 0.04F);
    const auto outlines = silhouette(points, Pose::Identity(), view, kView);
    ASSERT_EQ(outlines.size(), 1U);
    EXPECT_EQ(outlines[0].front(), outlines[0].back()) << "closed";
    // The cone that touches the ball; the mask is drawn in cells of 6 px, smoothing pulls inwards.
    const double radius_px =
        0.04 * view.px_per_m(kView) / std::sqrt(1.0 - std::pow(0.04 / view.distance_m, 2.0));
    for (const Eigen::Vector2d& p : outlines[0]) {
        EXPECT_NEAR((p - Eigen::Vector2d(450.0, 289.0)).norm(), radius_px, 9.0);
    }
}

TEST(Silhouette, OfTwoPartsAreTwoOutlinesAndSpecksAreLeftOut) {
    const OrbitCamera view = camera();
    const Eigen::Vector3f right = view.R_world_view().col(0).cast<float>();
    auto points = ball(8000, view.pivot_m.cast<float>() - 0.06F * right, 0.03F);
    const auto other = ball(8000, view.pivot_m.cast<float>() + 0.06F * right, 0.03F);
    points.insert(points.end(), other.begin(), other.end());
    points.push_back(view.pivot_m.cast<float>() + Eigen::Vector3f(0.0F, 0.08F, 0.0F));
    EXPECT_EQ(silhouette(points, Pose::Identity(), view, kView).size(), 2U);
    EXPECT_TRUE(silhouette({}, Pose::Identity(), view, kView).empty());
}

TEST(PictureCrop, TakesWhatLiesInThePicture) {
    std::vector<std::uint8_t> rgba(4 * 3 * 2);
    for (std::size_t i = 0; i < rgba.size(); ++i) rgba[i] = static_cast<std::uint8_t>(i / 4);
    Rect part{1, 1, 5, 5};
    EXPECT_EQ(cropped_rgba(rgba, 3, 2, part), (std::vector<std::uint8_t>{4, 4, 4, 4, 5, 5, 5, 5}));
    EXPECT_EQ(part, (Rect{1, 1, 2, 1}));
    Rect outside{9, 0, 2, 2};
    EXPECT_TRUE(cropped_rgba(rgba, 3, 2, outside).empty());
}

}  // namespace
}  // namespace gripscan::ui
