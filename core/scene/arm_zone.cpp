#include "core/scene/arm_zone.h"

#include <algorithm>
#include <array>

namespace gripscan {
namespace {

struct LinkCapsule {
    std::size_t link;  ///< 0: the base
    Capsule capsule;   ///< in the link's frame, kinematics.h
};

/// Castings of an LR Mate 200iC/5L with motor covers, generously.
const std::array<LinkCapsule, 10>& link_capsules() {
    static const std::array<LinkCapsule, 10> table = {{
        {0, {{0, 0, 0.06}, {0, 0, 0.16}, 0.125}},
        {0, {{-0.10, 0, 0.02}, {0.06, 0, 0.02}, 0.155}},
        {1, {{0, 0, -0.135}, {0, 0, 0}, 0.105}},
        {1, {{0.075, -0.06, 0}, {0.075, 0.06, 0}, 0.095}},
        {2, {{0, 0, 0}, {0, 0, 0.400}, 0.095}},
        {3, {{0, -0.04, 0}, {0, 0.04, 0}, 0.075}},
        {3, {{-0.05, 0, 0.06}, {0.10, 0, 0.07}, 0.112}},
        {4, {{0.12, 0, 0}, {0.40, 0, 0}, 0.070}},
        {5, {{0, 0, 0}, {0.05, 0, 0}, 0.048}},
        {6, {{-0.023, 0, 0}, {-0.012, 0, 0}, 0.034}},
    }};
    return table;
}

constexpr std::size_t kWrist = 5;

}  // namespace

double Capsule::distance_m(const Eigen::Vector3d& p_m) const {
    const Eigen::Vector3d along = b_m - a_m;
    const double length2 = along.squaredNorm();
    const double s = length2 > 0.0 ? std::clamp((p_m - a_m).dot(along) / length2, 0.0, 1.0) : 0.0;
    return (p_m - a_m - s * along).norm() - radius_m;
}

ArmZone::ArmZone(const JointAngles& joints_rad, const Pose& T_robot_camera, double margin_m)
    : margin_m_(margin_m) {
    const Pose T_camera_robot = T_robot_camera.inverse();
    const auto T_robot_link = link_poses(joints_rad);
    for (const LinkCapsule& part : link_capsules()) {
        const Pose T = T_camera_robot * T_robot_link[part.link];
        placed_.push_back({{T * part.capsule.a_m, T * part.capsule.b_m, part.capsule.radius_m},
                           part.link >= kWrist});
    }
    const Pose T_camera_tool = T_camera_robot * tool_pose(joints_rad);
    flange_m_ = T_camera_tool.translation();
    out_of_flange_ = T_camera_tool.linear().col(2);
}

bool ArmZone::contains(const Eigen::Vector3d& p_m) const {
    constexpr double kFace_m = 0.002;
    const bool before_flange = out_of_flange_.dot(p_m - flange_m_) > kFace_m;
    return std::any_of(placed_.begin(), placed_.end(), [&](const Placed& part) {
        return !(part.ends_at_flange && before_flange) && part.capsule.distance_m(p_m) < margin_m_;
    });
}

std::vector<std::size_t> ArmZone::outside(const Cloud& scene,
                                          const std::vector<std::size_t>& indices) const {
    std::vector<std::size_t> left;
    for (const std::size_t i : indices) {
        if (!contains(scene.points[i].cast<double>())) left.push_back(i);
    }
    return left;
}

std::vector<Capsule> ArmZone::capsules() const {
    std::vector<Capsule> result;
    for (const Placed& part : placed_) result.push_back(part.capsule);
    return result;
}

}  // namespace gripscan
