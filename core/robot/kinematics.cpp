#include "core/robot/kinematics.h"

#include <cmath>
#include <numbers>

#include "core/base/units.h"

namespace gripscan {
namespace {

struct Joint {
    Eigen::Vector3d origin_m;  ///< in the frame of the link before
    Eigen::Vector3d axis;
    JointRange range;
};

constexpr double kBaseHeight_m = 0.330;

JointRange range_deg(double min_deg, double max_deg) {
    return {rad_from_deg(min_deg), rad_from_deg(max_deg)};
}

// The chain as ROS-Industrial describes the arm (long version, 892 mm reach).
const std::array<Joint, 6>& chain() {
    static const std::array<Joint, 6> joints = {{
        {{0, 0, kBaseHeight_m}, Eigen::Vector3d::UnitZ(), range_deg(-170, 170)},
        {{0.075, 0, 0}, Eigen::Vector3d::UnitY(), range_deg(-90, 140)},
        {{0, 0, 0.400}, -Eigen::Vector3d::UnitY(), range_deg(-148, 230)},
        {{0, 0, 0.075}, -Eigen::Vector3d::UnitX(), range_deg(-190, 190)},
        {{0.410, 0, 0}, -Eigen::Vector3d::UnitY(), range_deg(-120, 120)},
        {{0.080, 0, 0}, -Eigen::Vector3d::UnitX(), range_deg(-360, 360)},
    }};
    return joints;
}

/// FANUC measures joint 3 against the horizontal, the chain against the upper arm.
JointAngles chain_angles(const JointAngles& joints_rad) {
    JointAngles q = joints_rad;
    q[2] += q[1];
    return q;
}

}  // namespace

const std::array<JointRange, 6>& joint_ranges() {
    static const std::array<JointRange, 6> ranges = [] {
        std::array<JointRange, 6> result;
        for (std::size_t i = 0; i < 6; ++i) result[i] = chain()[i].range;
        return result;
    }();
    return ranges;
}

Status check_joint_ranges(const JointAngles& joints_rad) {
    constexpr double kRounding_rad = 1e-9;  // a limit typed in degrees is inside
    const JointAngles q = chain_angles(joints_rad);
    for (std::size_t i = 0; i < 6; ++i) {
        const auto [min_rad, max_rad] = joint_ranges()[i];
        if (!(q[i] >= min_rad - kRounding_rad && q[i] <= max_rad + kRounding_rad)) {
            return input_error("joint {} at {:.3f} deg is outside {:.0f} … {:.0f} deg{}", i + 1,
                               deg_from_rad(q[i]), deg_from_rad(min_rad), deg_from_rad(max_rad),
                               i == 2 ? " (J2 + J3, against the upper arm)" : "");
        }
    }
    return {};
}

std::array<Pose, 7> link_poses(const JointAngles& joints_rad) {
    const JointAngles q = chain_angles(joints_rad);
    std::array<Pose, 7> T_world_link;
    T_world_link[0] = Pose(Eigen::Translation3d(0, 0, -kBaseHeight_m));
    for (std::size_t i = 0; i < 6; ++i) {
        const Joint& joint = chain()[i];
        T_world_link[i + 1] = T_world_link[i] * Eigen::Translation3d(joint.origin_m) *
                              Eigen::AngleAxisd(q[i], joint.axis);
    }
    return T_world_link;
}

Pose tool_pose(const JointAngles& joints_rad) {
    Pose T_flange_tool = Pose::Identity();
    T_flange_tool.linear() = rotation_from_euler({std::numbers::pi, -std::numbers::pi / 2.0, 0.0});
    return link_poses(joints_rad)[6] * T_flange_tool;
}

Axis joint_axis(const JointAngles& joints_rad, std::size_t number) {
    const Pose T_world_link = link_poses(joints_rad).at(number);
    return {T_world_link.translation(), T_world_link.linear() * chain().at(number - 1).axis};
}

}  // namespace gripscan
