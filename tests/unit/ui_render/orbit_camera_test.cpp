#include "ui/render/orbit_camera.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/support/random_pose.h"

namespace gripscan::ui {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;
constexpr double kHalfPi = 0.5 * std::numbers::pi;
const Viewport kView{900.0, 578.0};

OrbitCamera random_camera(SeededRandom& random) {
    OrbitCamera camera;
    camera.pivot_m = test::random_pose(random, 1.0).translation();
    camera.distance_m = random.uniform(0.1, 2.0);
    camera.yaw_rad = random.uniform(-3.0, 3.0);
    camera.pitch_rad = random.uniform(-1.5, 1.5);
    return camera;
}

Vector2d random_px(SeededRandom& random) {
    return {random.uniform(50, 850), random.uniform(50, 520)};
}

TEST(OrbitCamera, HasThePivotInTheMiddleAtItsDistance) {
    SeededRandom random(1);
    for (int i = 0; i < 200; ++i) {
        const OrbitCamera camera = random_camera(random);
        EXPECT_TRUE(project(camera, kView, camera.pivot_m)->isApprox(Vector2d(450, 289), 1e-9));
        EXPECT_NEAR((camera.T_view_world() * camera.pivot_m).z(), camera.distance_m, 1e-12);
        const Eigen::Matrix3d R = camera.R_world_view();
        EXPECT_TRUE((R * R.transpose()).isIdentity(1e-12));
        EXPECT_NEAR(R.determinant(), 1.0, 1e-12);
        EXPECT_NEAR(R(1, 0), 0.0, 1e-12) << "the horizon stays level";
    }
}

TEST(OrbitCamera, AtHomeLooksAsTheStereoCameraDoes) {
    const OrbitCamera camera = from_stereo_camera({}, 0.7);
    EXPECT_TRUE(camera.T_view_world().isApprox(Pose::Identity(), 1e-12));
    const auto px = project(camera, kView, {0.1, 0.1, 0.7});
    EXPECT_GT(px->x(), 450.0) << "x is to the right";
    EXPECT_GT(px->y(), 289.0) << "y is down";
}

TEST(OrbitCamera, UnprojectIsTheInverseOfProject) {
    SeededRandom random(2);
    for (int i = 0; i < 500; ++i) {
        const OrbitCamera camera = random_camera(random);
        const Vector2d px = random_px(random);
        const Vector3d p = unproject(camera, kView, px, random.uniform(0.05, 3.0));
        EXPECT_LT((*project(camera, kView, p) - px).norm(), 1e-6);
    }
    EXPECT_FALSE(project({}, kView, {0, 0, -5}).has_value()) << "behind the eye";
}

TEST(OrbitCamera, ClipCoordinatesAgreeWithThePixels) {
    SeededRandom random(3);
    for (int i = 0; i < 500; ++i) {
        const OrbitCamera camera = random_camera(random);
        const ClipRange range{0.05, 5.0};
        const Vector2d px = random_px(random);
        const double depth = random.uniform(0.06, 4.9);
        const Eigen::Vector4d clip = clip_from_world(camera, kView, range) *
                                     unproject(camera, kView, px, depth).homogeneous();
        EXPECT_NEAR((clip.x() / clip.w() + 1.0) * 0.5 * kView.width_px, px.x(), 1e-6);
        EXPECT_NEAR((1.0 - clip.y() / clip.w()) * 0.5 * kView.height_px, px.y(), 1e-6);
        EXPECT_LT(std::abs(clip.z() / clip.w()), 1.0);
        EXPECT_NEAR(clip.w(), depth, 1e-9);
    }
}

TEST(Orbit, KeepsPivotAndDistanceAndTheFrontFollowsTheMouse) {
    SeededRandom random(4);
    for (int i = 0; i < 200; ++i) {
        const OrbitCamera camera = random_camera(random);
        const OrbitCamera moved =
            orbited(camera, random.uniform(-300, 300), random.uniform(-300, 300), kView);
        EXPECT_EQ(moved.pivot_m, camera.pivot_m);
        EXPECT_NEAR((moved.eye_m() - camera.pivot_m).norm(), camera.distance_m, 1e-12);
    }
    const OrbitCamera home = from_stereo_camera({}, 1.0);
    const Vector3d front = home.pivot_m - 0.1 * Vector3d::UnitZ();  // towards the eye
    EXPECT_GT(project(orbited(home, 50, 0, kView), kView, front)->x(), 450.0);
    EXPECT_GT(project(orbited(home, 0, 50, kView), kView, front)->y(), 289.0);
}

TEST(Orbit, StopsAtThePolesAndCanBeTakenBack) {
    OrbitCamera camera;
    EXPECT_EQ(orbited(camera, 0, 1e6, kView).pitch_rad, kHalfPi);
    EXPECT_EQ(orbited(camera, 0, -1e6, kView).pitch_rad, -kHalfPi);
    camera.yaw_rad = 0.3;
    const OrbitCamera there = orbited(camera, 120, 40, kView);
    const OrbitCamera back = orbited(there, -120, -40, kView);
    EXPECT_NEAR(back.yaw_rad, camera.yaw_rad, 1e-12);
    EXPECT_NEAR(back.pitch_rad, camera.pitch_rad, 1e-12);
}

TEST(Pan, MovesWhatLiesAtThePivotsDepthWithTheMouse) {
    SeededRandom random(5);
    for (int i = 0; i < 200; ++i) {
        const OrbitCamera camera = random_camera(random);
        const Vector2d px = random_px(random);
        const Vector3d p = unproject(camera, kView, px, camera.distance_m);
        const OrbitCamera moved = panned(camera, 37, -21, kView);
        EXPECT_LT((*project(moved, kView, p) - px - Vector2d(37, -21)).norm(), 1e-6);
    }
}

TEST(Zoom, KeepsThePixelOfThePointUnderTheCursor) {
    SeededRandom random(6);
    for (int i = 0; i < 500; ++i) {
        const OrbitCamera camera = random_camera(random);
        const Vector2d px = random_px(random);
        const Vector3d anchor =
            unproject(camera, kView, px, camera.distance_m * random.uniform(0.5, 1.5));
        for (const double clicks : {1.0, -1.0, 3.0}) {
            const OrbitCamera moved = zoomed(camera, clicks, px, kView, anchor);
            EXPECT_LT((*project(moved, kView, anchor) - px).norm(), 1e-6);
            const double before = (anchor - camera.eye_m()).norm();
            EXPECT_EQ((anchor - moved.eye_m()).norm() < before, clicks > 0.0);
        }
    }
}

TEST(Zoom, NeverStopsAtThePivot) {
    OrbitCamera camera = from_stereo_camera({}, 0.5);
    const Vector3d first_pivot = camera.pivot_m;
    double travelled = 0.0;
    for (int i = 0; i < 200; ++i) {
        const OrbitCamera moved = zoomed(camera, 1.0, {450, 289}, kView);
        const double step = (moved.eye_m() - camera.eye_m()).dot(Vector3d::UnitZ());
        ASSERT_GT(step, 1e-4) << "click " << i;
        travelled += step;
        camera = moved;
    }
    EXPECT_GT(travelled, 0.55) << "through where the pivot was";
    EXPECT_GT(camera.pivot_m.z(), first_pivot.z());
}

TEST(Pivot, SetByADoubleClickIsInTheMiddleAndKeepsTheSizeThere) {
    SeededRandom random(7);
    for (int i = 0; i < 200; ++i) {
        const OrbitCamera camera = random_camera(random);
        const Vector3d p = unproject(camera, kView, random_px(random), random.uniform(0.05, 3.0));
        const OrbitCamera moved = with_pivot(camera, p);
        EXPECT_TRUE(project(moved, kView, p)->isApprox(Vector2d(450, 289), 1e-6));
        EXPECT_NEAR((moved.T_view_world() * p).z(), (camera.T_view_world() * p).z(), 1e-9);
        EXPECT_TRUE(moved.R_world_view().isApprox(camera.R_world_view()));
    }
}

TEST(Fit, ShowsEveryCornerFromTheSameSide) {
    SeededRandom random(8);
    for (int i = 0; i < 200; ++i) {
        const Vector3d a = test::random_pose(random, 1.0).translation();
        const Vector3d half(random.uniform(0.01, 0.5), random.uniform(0.01, 0.5),
                            random.uniform(0.01, 0.5));
        const Box box{a - half, a + half};
        const Viewport view{random.uniform(200, 1500), random.uniform(200, 1500)};
        const OrbitCamera camera = random_camera(random);
        const OrbitCamera moved = fitted(camera, box, view);
        EXPECT_EQ(moved.yaw_rad, camera.yaw_rad);
        for (const Vector3d& corner : box.corners()) {
            const auto px = project(moved, view, corner);
            ASSERT_TRUE(px.has_value());
            EXPECT_GE(px->x(), 0.0);
            EXPECT_LE(px->x(), view.width_px);
            EXPECT_GE(px->y(), 0.0);
            EXPECT_LE(px->y(), view.height_px);
        }
    }
}

TEST(AxisViews, LookAlongTheirAxes) {
    const auto forward = [](const OrbitCamera& camera) {
        return Vector3d(camera.R_world_view().col(2));
    };
    EXPECT_TRUE(forward(axis_view({}, AxisView::kFront)).isApprox(Vector3d::UnitZ()));
    EXPECT_TRUE(forward(axis_view({}, AxisView::kSide)).isApprox(-Vector3d::UnitX()));
    EXPECT_TRUE(forward(axis_view({}, AxisView::kTop)).isApprox(Vector3d::UnitY()))
        << "down, which is y";
    SeededRandom random(9);
    for (int i = 0; i < 200; ++i) {
        const Axis axis{test::random_pose(random, 1.0).translation(),
                        test::random_direction(random)};
        const OrbitCamera camera = looking_along(random_camera(random), axis);
        EXPECT_TRUE(forward(camera).isApprox(axis.direction, 1e-9));
        EXPECT_LT(axis.distance_m(camera.pivot_m), 1e-9);
    }
}

TEST(ClipRange, HoldsTheBallAndStaysResolvable) {
    SeededRandom random(10);
    for (int i = 0; i < 500; ++i) {
        const OrbitCamera camera = random_camera(random);
        const Vector3d centre = test::random_pose(random, 1.0).translation();
        const double radius = random.uniform(0.01, 1.0);
        const ClipRange range = clip_range(camera, centre, radius);
        EXPECT_GT(range.near_m, 0.0);
        EXPECT_LT(range.near_m, camera.distance_m);
        EXPECT_GE(range.far_m, (camera.T_view_world() * centre).z() + radius - 1e-9);
        EXPECT_LT(range.far_m / range.near_m, 20001.0);
    }
}

}  // namespace
}  // namespace gripscan::ui
