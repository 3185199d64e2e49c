#include "core/sim/sim_camera.h"

#include <gtest/gtest.h>

#include <opencv2/core.hpp>

#include "core/base/units.h"
#include "core/concurrency/worker_pool.h"
#include "core/sim/swept_volume.h"
#include "tests/unit/sim/small_cell.h"

namespace gripscan::sim {
namespace {

bool same(const cv::Mat& a, const cv::Mat& b) {
    return a.size() == b.size() && cv::countNonZero(a != b) == 0;
}

TEST(SimCamera, ATurnedPictureEqualsOneRenderedAfresh) {
    for (const char* gripper : {"two-finger", "suction"}) {
        const auto turned = make_small_cell({.seed = 3, .gripper = gripper});
        for (const double deg : {-180.0, -150.0, -40.0})
            (void)turned->picture_at(rad_from_deg(deg));
        const StereoFrame a = turned->picture_at(rad_from_deg(77.0), {5, 1});
        const auto fresh = make_small_cell({.seed = 3, .gripper = gripper});
        const StereoFrame b = fresh->picture_at(rad_from_deg(77.0), {5, 1});
        EXPECT_TRUE(same(a.left, b.left)) << gripper;
        EXPECT_TRUE(same(a.right, b.right)) << gripper;
        EXPECT_FALSE(same(a.left, turned->picture_at(rad_from_deg(80.0), {5, 1}).left));
    }
}

TEST(SimCamera, NoiseBelongsToCaptureAttemptAndCamera) {
    const auto cell = make_small_cell({.noise_levels = 2.0});
    const StereoFrame first = cell->picture_at(0.0, {3, 1});
    EXPECT_TRUE(same(first.left, cell->picture_at(0.0, {3, 1}).left));
    const StereoFrame retake = cell->picture_at(0.0, {3, 2});
    const StereoFrame other = cell->picture_at(0.0, {4, 1});
    for (const cv::Mat& again : {retake.left, other.left}) {
        cv::Mat difference;
        cv::subtract(first.left, again, difference, {}, CV_32F);
        cv::Scalar mean, sigma;
        cv::meanStdDev(difference, mean, sigma);
        EXPECT_NEAR(mean[0], 0.0, 0.05);
        // Two noises of 2 levels and twice the rounding to whole levels, 1/√12; 76,800 pixels.
        EXPECT_NEAR(sigma[0], std::sqrt(2.0 * (4.0 + 1.0 / 12.0)), 0.04);
    }
}

TEST(SimCamera, BlurIsTheGaussianAskedFor) {
    cv::Mat edge(21, 61, CV_32F, cv::Scalar(50.0));
    edge.colRange(31, 61).setTo(200.0);
    const cv::Mat image = sensor_image(
        edge, {.blur_px = 0.6, .noise_levels = 0.0, .vignetting = 0.0}, 1, for_each_in_order);
    // The edge lies at 30.5; integrals of the sampled Gaussian exp(−x²/2σ²), σ = 0.6.
    const double w1 = std::exp(-1.0 / 0.72);
    const double w2 = std::exp(-4.0 / 0.72);
    const double beyond = (w1 + w2) / (1.0 + 2.0 * w1 + 2.0 * w2);
    EXPECT_NEAR(image.at<std::uint8_t>(10, 30), 50.0 + 150.0 * beyond, 1.0);
    EXPECT_NEAR(image.at<std::uint8_t>(10, 31), 200.0 - 150.0 * beyond, 1.0);
    EXPECT_EQ(image.at<std::uint8_t>(10, 20), 50);
}

TEST(SimCamera, VignettingTakesTheStatedShareFromTheCorners) {
    const cv::Mat flat(97, 129, CV_32F, cv::Scalar(200.0));
    const cv::Mat image = sensor_image(
        flat, {.blur_px = 0.6, .noise_levels = 0.0, .vignetting = 0.25}, 1, for_each_in_order);
    EXPECT_EQ(image.at<std::uint8_t>(48, 64), 200);
    EXPECT_EQ(image.at<std::uint8_t>(0, 0), 150);
    EXPECT_EQ(image.at<std::uint8_t>(96, 128), 150);
}

TEST(SimCamera, ThreadsDoNotMatter) {
    const auto cell = make_small_cell({.noise_levels = 2.0});
    const StereoFrame one = cell->picture_at(0.3, {2, 1});
    WorkerPool pool(3);
    const auto camera = SimCamera::create(
                            cell->layout, cell->model, cell->region, {{0.6, 2.0, 0.22}, 1},
                            [&](const FrameRequest&) { return cell->moment(); }, pool.for_each())
                            .value();
    const StereoFrame three = camera->grab({2, 1}).value();
    EXPECT_TRUE(same(one.left, three.left));
    EXPECT_TRUE(same(one.right, three.right));
}

TEST(SweptVolume, EnclosesTheTurningPartsAtEveryAngle) {
    for (const std::string gripper : {"two-finger", "three-finger", "parallel-wide", "suction"}) {
        const auto cell = make_small_cell({.gripper = gripper});
        auto swept = RayScene::create(swept_scene(cell->model)).value();
        JointAngles q = cell->layout.joints_rad;
        swept.place(body_poses(q));
        for (int step = 0; step < 12; ++step) {
            q[5] = rad_from_deg(30.0 * step - 180.0);
            const auto T_world_body = body_poses(q);
            for (const std::size_t body : {SceneModel::kFlange, SceneModel::kTool}) {
                for (const Part& part : cell->model.bodies[body].parts) {
                    for (std::size_t i = 0; i < part.mesh.vertices.size(); i += 5) {
                        // Whatever leaves the point outwards must pass the hull.
                        const Eigen::Vector3d p = T_world_body[body] * part.mesh.vertices[i];
                        const Eigen::Vector3d away = p + Eigen::Vector3d(0.1, 0.5, 0.7);
                        EXPECT_TRUE(swept.blocked(p.cast<float>(), away.cast<float>()))
                            << gripper << " " << part.name;
                    }
                }
            }
        }
    }
}

}  // namespace
}  // namespace gripscan::sim
