#include "core/robot/inverse_kinematics.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "core/base/units.h"

namespace gripscan {
namespace {

// The chain of kinematics.cpp as lengths, m.
constexpr double kShoulder_m = 0.075;  ///< axis 2 before axis 1
constexpr double kUpperArm_m = 0.400;
constexpr double kForearmRise_m = 0.075;
constexpr double kForearm_m = 0.410;
constexpr double kFlange_m = 0.080;  ///< face of the flange before the wrist's centre
const double kElbowToWrist_m = std::hypot(kForearm_m, kForearmRise_m);

constexpr double kTurn_rad = 2.0 * std::numbers::pi;
/// Below this sine of joint 5, axes 4 and 6 are one line.
constexpr double kStraightWrist = 1e-9;

double wrapped(double angle_rad) {
    return std::remainder(angle_rad, kTurn_rad);
}

Eigen::Matrix3d about_y(double angle_rad) {
    return Eigen::AngleAxisd(angle_rad, Eigen::Vector3d::UnitY()).toRotationMatrix();
}

struct ArmAngles {
    double j1, j2, j3;  ///< FANUC: j3 against the horizontal
    bool front, elbow_up;
};

/// Joints 1 … 3 for the centre of the wrist: forward or over the back, elbow up or down.
std::vector<ArmAngles> arm_angles(const Eigen::Vector3d& wrist_m, double near_j1) {
    std::vector<ArmAngles> found;
    const bool on_axis1 = std::hypot(wrist_m.x(), wrist_m.y()) < 1e-12;
    const double forward = on_axis1 ? near_j1 : std::atan2(wrist_m.y(), wrist_m.x());
    for (const bool front : {true, false}) {
        const double j1 = front ? forward : wrapped(forward + std::numbers::pi);
        const double r = std::cos(j1) * wrist_m.x() + std::sin(j1) * wrist_m.y() - kShoulder_m;
        const double z = wrist_m.z();
        const double distance = std::hypot(r, z);
        if (distance < 1e-12) continue;
        const double cosine =
            (kUpperArm_m * kUpperArm_m + distance * distance - kElbowToWrist_m * kElbowToWrist_m) /
            (2.0 * kUpperArm_m * distance);
        if (std::abs(cosine) > 1.0 + 1e-12) continue;
        const double opening = std::acos(std::clamp(cosine, -1.0, 1.0));
        for (const bool up : {true, false}) {
            // Over the back, "up" is on the other side of the line from shoulder to wrist.
            const double side = up == front ? 1.0 : -1.0;
            const double upper_arm = std::atan2(z, r) + side * opening;
            const double forearm = std::atan2(z - kUpperArm_m * std::sin(upper_arm),
                                              r - kUpperArm_m * std::cos(upper_arm));
            found.push_back({j1, wrapped(std::numbers::pi / 2.0 - upper_arm),
                             wrapped(forearm - std::atan2(kForearmRise_m, kForearm_m)), front, up});
        }
    }
    return found;
}

struct WristAngles {
    double j4, j5, j6;
};

/// Joints 4 … 6 for the rotation of link 6 in link 3: Rx(−j4) · Ry(−j5) · Rx(−j6).
std::vector<WristAngles> wrist_angles(const Eigen::Matrix3d& R, double near_j4) {
    const double sine = std::hypot(R(0, 1), R(0, 2));
    if (sine < kStraightWrist) {
        const double sum = std::atan2(R(2, 1), R(1, 1));
        return {{near_j4, R(0, 0) > 0.0 ? 0.0 : std::numbers::pi, wrapped(-sum - near_j4)}};
    }
    std::vector<WristAngles> both;
    for (const double sign : {1.0, -1.0}) {
        const double a = std::atan2(sign * R(1, 0), -sign * R(2, 0));
        const double b = std::atan2(sign * sine, R(0, 0));
        const double c = std::atan2(sign * R(0, 1), sign * R(0, 2));
        both.push_back({-a, -b, -c});
    }
    return both;
}

/// The angle and its full turns within the range; the angle itself if none is.
std::vector<double> turns_in_range(double angle_rad, const JointRange& range) {
    std::vector<double> found;
    for (const double turns : {0.0, 1.0, -1.0}) {
        const double a = wrapped(angle_rad) + turns * kTurn_rad;
        if (a >= range.min_rad - 1e-9 && a <= range.max_rad + 1e-9) found.push_back(a);
    }
    if (found.empty()) found.push_back(wrapped(angle_rad));
    return found;
}

/// Joints 2 and 3 as their motors may count them: within the range if any full turn is. The elbow's
/// own angle, which is their sum, has a range of more than a turn.
std::vector<std::pair<double, double>> counted_as_motors(double j2_rad, double j3_rad) {
    std::vector<std::pair<double, double>> ways;
    const double j2 = turns_in_range(j2_rad, joint_ranges()[1]).front();
    for (const double elbow : turns_in_range(j3_rad + j2_rad, joint_ranges()[2])) {
        ways.emplace_back(j2, elbow - j2);
    }
    return ways;
}

double largest_motion(const JointAngles& a, const JointAngles& b) {
    double largest = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i) largest = std::max(largest, std::abs(a[i] - b[i]));
    return largest;
}

Pose link6_pose(const Pose& T_world_tool) {
    const Pose T_flange_tool = link_poses({})[6].inverse() * tool_pose({});
    return T_world_tool * T_flange_tool.inverse();
}

}  // namespace

std::vector<ArmSolution> inverse_kinematics(const Pose& T_world_tool, const JointAngles& near_rad) {
    const Pose T_world_link6 = link6_pose(T_world_tool);
    const Eigen::Vector3d wrist_m =
        T_world_link6.translation() - kFlange_m * T_world_link6.linear().col(0);
    std::vector<ArmSolution> all;
    for (const ArmAngles& arm : arm_angles(wrist_m, near_rad[0])) {
        const Eigen::Matrix3d R_world_link3 =
            Eigen::AngleAxisd(arm.j1, Eigen::Vector3d::UnitZ()).toRotationMatrix() *
            about_y(-arm.j3);
        const Eigen::Matrix3d R = R_world_link3.transpose() * T_world_link6.linear();
        const auto add = [&](const std::pair<double, double>& j23, double j4, double j5,
                             double j6) {
            ArmSolution solution;
            solution.joints_rad = {arm.j1, j23.first, j23.second, j4, j5, j6};
            solution.front = arm.front;
            solution.elbow_up = arm.elbow_up;
            solution.wrist_positive = j5 > 0.0;
            const Status in_range = check_joint_ranges(solution.joints_rad);
            if (!in_range) solution.obstacle = in_range.error().message;
            all.push_back(std::move(solution));
        };
        for (const auto& j23 : counted_as_motors(arm.j2, arm.j3)) {
            for (const WristAngles& wrist : wrist_angles(R, near_rad[3])) {
                for (const double j4 : turns_in_range(wrist.j4, joint_ranges()[3])) {
                    for (const double j6 : turns_in_range(wrist.j6, joint_ranges()[5])) {
                        add(j23, j4, wrist.j5, j6);
                    }
                }
            }
        }
    }
    return all;
}

Reachability reachability(const Pose& T_world_tool, const JointAngles& near_rad) {
    Reachability result;
    auto all = inverse_kinematics(T_world_tool, near_rad);
    if (all.empty()) {
        const Pose T = link6_pose(T_world_tool);
        const Eigen::Vector3d wrist_m = T.translation() - kFlange_m * T.linear().col(0);
        const double away_m =
            std::hypot(std::hypot(wrist_m.x(), wrist_m.y()) - kShoulder_m, wrist_m.z());
        result.sentence = fmt::format(
            "out of reach: the wrist would be {:.0f} mm from axis 2, the arm reaches {:.0f} to "
            "{:.0f} mm",
            kMmPerM * away_m, kMmPerM * std::abs(kUpperArm_m - kElbowToWrist_m),
            kMmPerM * (kUpperArm_m + kElbowToWrist_m));
        return result;
    }
    std::stable_sort(all.begin(), all.end(), [&](const ArmSolution& a, const ArmSolution& b) {
        return largest_motion(a.joints_rad, near_rad) < largest_motion(b.joints_rad, near_rad);
    });
    for (const ArmSolution& solution : all) {
        if (solution.obstacle.empty()) result.solutions.push_back(solution);
    }
    result.reachable = !result.solutions.empty();
    if (!result.reachable) {
        result.sentence =
            fmt::format("not reachable in any of {} ways: {}", all.size(), all.front().obstacle);
        return result;
    }
    result.joints_rad = result.solutions.front().joints_rad;
    result.sentence = fmt::format(
        "reachable in {} ways; in the nearest no joint turns by more than {:.1f} deg",
        result.solutions.size(), deg_from_rad(largest_motion(result.joints_rad, near_rad)));
    return result;
}

}  // namespace gripscan
