#include "core/sim/cell_layout.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <opencv2/calib3d.hpp>
#include <opencv2/core/eigen.hpp>

#include "core/base/units.h"
#include "core/robot/kinematics.h"
#include "core/sim/seeds.h"

namespace gripscan::sim {
namespace {

constexpr double kMargin_m = 0.020;

Eigen::Matrix3d camera_matrix(double f_px, double cx_px, double cy_px) {
    Eigen::Matrix3d K;
    K << f_px, 0, cx_px, 0, f_px, cy_px, 0, 0, 1;
    return K;
}

Eigen::Matrix3d left_rectification(const StereoRig& rig) {
    cv::Mat K1, K2, R, T;
    cv::eigen2cv(rig.K_left, K1);
    cv::eigen2cv(rig.K_right, K2);
    cv::eigen2cv(Eigen::Matrix3d(rig.T_right_left.linear()), R);
    cv::eigen2cv(Eigen::Vector3d(rig.T_right_left.translation()), T);
    cv::Mat R1, R2, P1, P2, Q;
    cv::stereoRectify(K1, rig.D_left, K2, rig.D_right, {rig.image.width, rig.image.height}, R, T,
                      R1, R2, P1, P2, Q, cv::CALIB_ZERO_DISPARITY, -1);
    Eigen::Matrix3d result;
    cv::cv2eigen(R1, result);
    return result;
}

/// Camera x against the arm's reach, y down, z towards the arm; tilted down by 6°.
Eigen::Matrix3d nominal_view() {
    Eigen::Matrix3d R_world_camera;
    R_world_camera << -1, 0, 0, 0, 0, -1, 0, -1, 0;
    return R_world_camera *
           Eigen::AngleAxisd(rad_from_deg(-6.0), Eigen::Vector3d::UnitX()).toRotationMatrix();
}

Pose camera_pose(const JointAngles& joints_rad, std::uint64_t seed) {
    SeededRandom random(seed);
    const auto within = [&](double limit) {
        return Eigen::Vector3d(random.uniform(-limit, limit), random.uniform(-limit, limit),
                               random.uniform(-limit, limit));
    };
    Pose T = Pose::Identity();
    T.linear() = nominal_view() * rotation_from_vector(within(rad_from_deg(1.5)));
    const Eigen::Vector3d gripper_in_camera_m =
        Eigen::Vector3d(-0.045, 0.010, kDistance_m) + within(0.015);
    const Eigen::Vector3d gripper_m =
        tool_pose(joints_rad) * Eigen::Vector3d(0, 0, kGripperCentre_m);
    T.translation() = gripper_m - T.linear() * gripper_in_camera_m;
    return T;
}

struct Reach {
    double radius_m = 0.0;
    double end_m = 0.0;  ///< along the axis, out of the flange
};

/// Of the gripper and what it holds.
Reach reach_of(const SceneModel& model) {
    Reach reach;
    for (const std::size_t body : {SceneModel::kTool, SceneModel::kObject}) {
        for (const Part& part : model.bodies[body].parts) {
            for (const Eigen::Vector3d& v : part.mesh.vertices) {
                reach.radius_m = std::max(reach.radius_m, std::hypot(v.x(), v.y()));
                reach.end_m = std::max(reach.end_m, v.z());
            }
        }
    }
    return reach;
}

}  // namespace

Pose CellLayout::T_world_left() const {
    Pose T_camera_left = Pose::Identity();
    T_camera_left.linear() = R_camera_left;
    return T_world_camera * T_camera_left;
}

Pose CellLayout::T_world_right() const {
    return T_world_left() * rig.T_right_left.inverse();
}

StereoRig default_rig() {
    StereoRig rig;
    rig.image = {1280, 960};
    rig.K_left = camera_matrix(985.0, 643.1, 477.2);
    rig.K_right = camera_matrix(985.0, 636.4, 482.5);
    rig.D_left = {-0.062, 0.021, 0.0004, -0.0003, 0.0};
    rig.D_right = {-0.058, 0.018, -0.0003, 0.0005, 0.0};
    rig.T_right_left.linear() =
        rotation_from_vector({rad_from_deg(0.35), rad_from_deg(-0.6), rad_from_deg(0.25)});
    rig.T_right_left.translation() = 0.12 * Eigen::Vector3d(-1.0, 0.006, -0.010).normalized();
    return rig;
}

StereoRig shrunk(const StereoRig& rig, unsigned fraction) {
    StereoRig small = rig;
    const int n = static_cast<int>(fraction);
    small.image = {rig.image.width / n, rig.image.height / n};
    for (Eigen::Matrix3d* K : {&small.K_left, &small.K_right}) {
        // Pixel centres are whole numbers, so places scale about the corner (-0.5, -0.5).
        K->topRows<2>() /= n;
        K->topRightCorner<2, 1>().array() += 0.5 / n - 0.5;
    }
    return small;
}

CellLayout make_layout(std::uint64_t seed) {
    CellLayout layout;
    layout.joints_rad = {rad_from_deg(-2.0), rad_from_deg(-4.0), rad_from_deg(1.5),
                         rad_from_deg(7.0),  rad_from_deg(-3.0), rad_from_deg(-180.0)};
    layout.rig = default_rig();
    layout.R_camera_left = left_rectification(layout.rig);
    layout.T_world_camera = camera_pose(layout.joints_rad, seed_for(seed, Use::kCamera));
    layout.light_seed = seed_for(seed, Use::kLights);
    return layout;
}

Axis joint6_axis_in_camera(const CellLayout& layout) {
    const Pose T_camera_world = layout.T_world_camera.inverse();
    const Axis axis = joint_axis(layout.joints_rad, 6);
    return {T_camera_world * axis.point_m, T_camera_world.linear() * axis.direction};
}

Box registration_area(const CellLayout& layout, const SceneModel& with_arm) {
    const Pose T_camera_world = layout.T_world_camera.inverse();
    const auto T_world_body = body_poses(layout.joints_rad);
    const Pose T_camera_tool = T_camera_world * T_world_body[SceneModel::kTool];
    const Reach reach = reach_of(with_arm);

    // A disc of radius r about the direction a reaches r · sqrt(1 − a_i²) along coordinate i.
    const Eigen::Vector3d a = T_camera_tool.linear().col(2);
    const Eigen::Vector3d disc =
        reach.radius_m * (Eigen::Vector3d::Ones() - a.cwiseAbs2()).cwiseMax(0.0).cwiseSqrt();
    const Eigen::Vector3d flange_m = T_camera_tool.translation();
    const Eigen::Vector3d tip_m = flange_m + a * reach.end_m;
    Box box;
    box.min_m = flange_m.cwiseMin(tip_m) - disc - Eigen::Vector3d::Constant(kMargin_m);
    box.max_m = flange_m.cwiseMax(tip_m) + disc + Eigen::Vector3d::Constant(kMargin_m);

    double arm_x_m = std::numeric_limits<double>::infinity();
    for (std::size_t i = 1; i < SceneModel::kFlange; ++i) {
        for (const Part& part : with_arm.bodies[i].parts) {
            for (const Eigen::Vector3d& v : part.mesh.vertices) {
                arm_x_m = std::min(arm_x_m, (T_camera_world * T_world_body[i] * v).x());
            }
        }
    }
    box.max_m.x() = std::min(box.max_m.x(), arm_x_m - kMargin_m);
    return box;
}

}  // namespace gripscan::sim
