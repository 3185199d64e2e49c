// Does the rendered pair show the scene where the rig says? Points of the solids are found by
// casting rays, projected by OpenCV, and looked up in the pictures.
#include <gtest/gtest.h>

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <opencv2/calib3d.hpp>
#include <opencv2/core/eigen.hpp>
#include <opencv2/imgproc.hpp>

#include "core/base/units.h"
#include "core/robot/kinematics.h"
#include "core/sim/surface_samples.h"
#include "core/sim/visibility.h"
#include "tests/unit/sim/small_cell.h"

namespace gripscan::sim {
namespace {

struct Rectification {
    cv::Mat K1, K2, R1, R2, P1, P2;
    explicit Rectification(const StereoRig& rig) {
        cv::Mat R, T, Q;
        cv::eigen2cv(rig.K_left, K1);
        cv::eigen2cv(rig.K_right, K2);
        cv::eigen2cv(Eigen::Matrix3d(rig.T_right_left.linear()), R);
        cv::eigen2cv(Eigen::Vector3d(rig.T_right_left.translation()), T);
        cv::stereoRectify(K1, rig.D_left, K2, rig.D_right, {rig.image.width, rig.image.height}, R,
                          T, R1, R2, P1, P2, Q, cv::CALIB_ZERO_DISPARITY, -1);
    }
};

Eigen::Vector2d rectified(const Eigen::Vector2d& p, const cv::Mat& K, const std::vector<double>& D,
                          const cv::Mat& R, const cv::Mat& P) {
    std::vector<cv::Point2d> out;
    cv::undistortPoints(std::vector<cv::Point2d>{{p.x(), p.y()}}, out, K, D, R, P,
                        {cv::TermCriteria::COUNT | cv::TermCriteria::EPS, 100, 1e-12});
    return {out[0].x, out[0].y};
}

/// Samples of the gripper that both cameras see, in tool0.
std::vector<SurfaceSample> visible_samples(const SmallCell& cell, const JointAngles& joints_rad) {
    std::vector<SurfaceSample> samples;
    for (const Part& part : cell.model.bodies[SceneModel::kTool].parts) {
        for (const auto& sample : sample_surface(part.mesh, 0.002)) samples.push_back(sample);
    }
    VisibilityTest test(cell.layout, cell.region, RayScene::create(cell.model).value());
    std::vector<char> seen(samples.size(), 0);
    Moment moment;
    moment.true_rad = joints_rad;
    test.mark(moment, SceneModel::kTool, samples, seen, for_each_in_order);
    std::vector<SurfaceSample> result;
    for (std::size_t i = 0; i < samples.size(); ++i) {
        if (seen[i] != 0) result.push_back(samples[i]);
    }
    return result;
}

/// Those of them around which the surface is flat and visible: nothing else shows in their patch of
/// the picture.
std::vector<SurfaceSample> amid_flat_faces(const std::vector<SurfaceSample>& samples) {
    constexpr double kRadius_m = 0.006;
    constexpr double kSpacing_m = 0.002;
    const double expected = std::numbers::pi * kRadius_m * kRadius_m / (kSpacing_m * kSpacing_m);
    std::vector<SurfaceSample> result;
    for (const SurfaceSample& sample : samples) {
        int alike = 0;
        int others = 0;
        for (const SurfaceSample& other : samples) {
            if ((other.point_m - sample.point_m).norm() > kRadius_m) continue;
            ++(other.normal.dot(sample.normal) > 0.999 ? alike : others);
        }
        if (others == 0 && alike > 0.85 * expected) result.push_back(sample);
    }
    return result;
}

TEST(StereoGeometry, RowsAgreeAndDisparityGivesTheDepthInTheCameraFrame) {
    const auto cell = make_small_cell({.image_fraction = 1});
    const Rectification r(cell->layout.rig);
    const StereoRig& rig = cell->layout.rig;
    const double f = r.P1.at<double>(0, 0);
    const double B = -r.P2.at<double>(0, 3) / f;
    EXPECT_NEAR(B, 0.12, 1e-9);
    const auto q = cell->layout.joints_rad;
    const Pose T_world_tool = tool_pose(q);
    const auto samples = visible_samples(*cell, q);
    ASSERT_GT(samples.size(), 1000U);
    const Lens left_lens = cell->left_lens();
    const Lens right_lens = cell->right_lens();
    for (std::size_t i = 0; i < samples.size(); i += 7) {
        const Eigen::Vector3d p = T_world_tool * samples[i].point_m;
        const Eigen::Vector2d left =
            rectified(left_lens.project(cell->layout.T_world_left().inverse() * p), r.K1,
                      rig.D_left, r.R1, r.P1);
        const Eigen::Vector2d right =
            rectified(right_lens.project(cell->layout.T_world_right().inverse() * p), r.K2,
                      rig.D_right, r.R2, r.P2);
        const Eigen::Vector3d in_camera = cell->layout.T_world_camera.inverse() * p;
        EXPECT_NEAR(left.y(), right.y(), 1e-5);
        EXPECT_NEAR(f * B / (left.x() - right.x()), in_camera.z(), 1e-7);
        EXPECT_NEAR((left.x() - r.P1.at<double>(0, 2)) * in_camera.z() / f, in_camera.x(), 1e-7);
        EXPECT_NEAR((left.y() - r.P1.at<double>(1, 2)) * in_camera.z() / f, in_camera.y(), 1e-7);
    }
}

TEST(StereoGeometry, ARayThroughAPointsImageMeetsThatPoint) {
    const auto cell = make_small_cell({.image_fraction = 1});
    const auto q = cell->layout.joints_rad;
    auto scene = RayScene::create(cell->model).value();
    scene.place(body_poses(q));
    const Lens lens = cell->right_lens();
    const Pose T_world_right = cell->layout.T_world_right();
    const auto samples = visible_samples(*cell, q);
    std::size_t agree = 0;
    for (const SurfaceSample& sample : samples) {
        const Eigen::Vector3d p = tool_pose(q) * sample.point_m;
        const Eigen::Vector2d image = lens.project(T_world_right.inverse() * p);
        const Eigen::Vector2f x =
            lens.direction_at(static_cast<float>(image.x()), static_cast<float>(image.y()));
        const Eigen::Vector3d direction =
            (T_world_right.linear() * Eigen::Vector3d(x.x(), x.y(), 1.0)).normalized();
        Hit hit;
        ASSERT_TRUE(
            scene.trace(T_world_right.translation().cast<float>(), direction.cast<float>(), hit));
        agree += (hit.local_m.cast<double>() - sample.point_m).norm() < 2e-5 ? 1 : 0;
    }
    // The rest lies on edges, where the ray goes a thousandth of a pixel past them, or less than
    // 0.05 mm under another surface, which the test of visibility lets pass.
    EXPECT_GT(static_cast<double>(agree), 0.985 * static_cast<double>(samples.size()));
}

/// The picture less its surroundings, over their contrast: texture without shading.
cv::Mat texture_of(const cv::Mat& picture) {
    cv::Mat level, mean, square, result;
    picture.convertTo(level, CV_32F);
    cv::GaussianBlur(level, mean, {}, 2.0);
    result = level - mean;
    cv::GaussianBlur(result.mul(result), square, {}, 2.0);
    cv::sqrt(square + 1.0, square);
    return result / square;
}

float at(const cv::Mat& image, const Eigen::Vector2d& p) {
    cv::Mat patch;
    cv::getRectSubPix(image, {1, 1}, {static_cast<float>(p.x()), static_cast<float>(p.y())}, patch);
    return patch.at<float>(0, 0);
}

double correlation(const cv::Mat& a, const std::vector<Eigen::Vector2d>& in_a, const cv::Mat& b,
                   const std::vector<Eigen::Vector2d>& in_b, const Eigen::Vector2d& shift) {
    double ab = 0.0;
    double aa = 0.0;
    double bb = 0.0;
    for (std::size_t i = 0; i < in_a.size(); ++i) {
        const double x = at(a, in_a[i]);
        const double y = at(b, in_b[i] + shift);
        ab += x * y;
        aa += x * x;
        bb += y * y;
    }
    return ab / std::sqrt(aa * bb);
}

/// The shift of b, in px, at which both pictures of the same points agree best: 0 if they show the
/// points where the projection says. A parabola through the correlations at −1, 0, 1.
Eigen::Vector2d best_shift(const cv::Mat& a, const std::vector<Eigen::Vector2d>& in_a,
                           const cv::Mat& b, const std::vector<Eigen::Vector2d>& in_b) {
    Eigen::Vector2d best;
    for (int i = 0; i < 2; ++i) {
        const Eigen::Vector2d unit = Eigen::Vector2d::Unit(i);
        const double low = correlation(a, in_a, b, in_b, -unit);
        const double mid = correlation(a, in_a, b, in_b, Eigen::Vector2d::Zero());
        const double high = correlation(a, in_a, b, in_b, unit);
        EXPECT_GT(mid, 0.6);
        EXPECT_GT(mid, 1.2 * std::max(low, high));
        best[i] = 0.5 * (low - high) / (low - 2.0 * mid + high);
    }
    return best;
}

std::vector<Eigen::Vector2d> images_of(const std::vector<SurfaceSample>& samples, const Lens& lens,
                                       const Pose& T_eye_tool) {
    std::vector<Eigen::Vector2d> images;
    for (const auto& sample : samples) images.push_back(lens.project(T_eye_tool * sample.point_m));
    return images;
}

TEST(StereoGeometry, BothPicturesShowTheSamePointsWhereTheyProject) {
    // A quarter of the resolution would alias the grain; half of it still shows it.
    const auto cell = make_small_cell({.blur_px = 0.5, .image_fraction = 2});
    const StereoFrame frame = cell->picture_at(rad_from_deg(-180.0));
    const JointAngles q = cell->moment().true_rad;
    const auto samples = amid_flat_faces(visible_samples(*cell, q));
    ASSERT_GT(samples.size(), 500U);
    const Pose T_world_tool = tool_pose(q);
    const auto in_left =
        images_of(samples, cell->left_lens(), cell->layout.T_world_left().inverse() * T_world_tool);
    const auto in_right = images_of(samples, cell->right_lens(),
                                    cell->layout.T_world_right().inverse() * T_world_tool);
    const Eigen::Vector2d shift =
        best_shift(texture_of(frame.left), in_left, texture_of(frame.right), in_right);
    // A thousand independent grains, each placed to about a pixel.
    EXPECT_LT(shift.norm(), 0.05);
}

TEST(StereoGeometry, TurningJoint6MovesThePictureAsTheAxisSays) {
    const auto cell = make_small_cell({.blur_px = 0.5, .image_fraction = 2});
    const cv::Mat before = texture_of(cell->picture_at(rad_from_deg(-180.0)).left);
    const JointAngles q0 = cell->moment().true_rad;
    const cv::Mat after = texture_of(cell->picture_at(rad_from_deg(-170.0)).left);
    const JointAngles q1 = cell->moment().true_rad;

    auto samples = visible_samples(*cell, q0);
    const Pose T_camera_tool = cell->layout.T_world_camera.inverse() * tool_pose(q0);
    const Axis axis = joint6_axis_in_camera(cell->layout);
    const Pose turn = turn_about(axis, q1[5] - q0[5]);
    // By the chain of joints, and by the axis in the camera frame: the same motion.
    EXPECT_LT(
        (turn * T_camera_tool)
                .matrix()
                .isApprox((cell->layout.T_world_camera.inverse() * tool_pose(q1)).matrix(), 1e-12)
            ? 0.0
            : 1.0,
        0.5);
    EXPECT_GT(axis.direction.x(), 0.99);

    const auto later = visible_samples(*cell, q1);
    const auto is_later = [&](const SurfaceSample& s) {
        return std::any_of(later.begin(), later.end(),
                           [&](const SurfaceSample& other) { return other.point_m == s.point_m; });
    };
    std::erase_if(samples, [&](const SurfaceSample& s) { return !is_later(s); });
    samples = amid_flat_faces(samples);
    ASSERT_GT(samples.size(), 500U);
    Pose T_left_camera = Pose::Identity();
    T_left_camera.linear() = cell->layout.R_camera_left.transpose();
    const auto in_before = images_of(samples, cell->left_lens(), T_left_camera * T_camera_tool);
    const auto in_after =
        images_of(samples, cell->left_lens(), T_left_camera * turn * T_camera_tool);
    const Eigen::Vector2d shift = best_shift(before, in_before, after, in_after);
    // Shading changes with the turn, so this is looser; a turn to the other side shifts by tens.
    EXPECT_LT(shift.norm(), 0.08);
}

}  // namespace
}  // namespace gripscan::sim
