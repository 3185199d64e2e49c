// All solids of the cell and which link carries them: what exists, not how it is drawn.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "core/robot/robot_link.h"
#include "core/sim/part.h"

namespace gripscan::sim {

/// A rigid group of parts: the surroundings, or one link with what is mounted on it.
struct Body {
    std::vector<Part> parts;  ///< in the body's frame
};

/// Body 0 is the surroundings (in WORLD), 1 the arm's base, 2 … 7 links 1 … 6, 8 what is mounted
/// on the flange (in tool0), 9 a strange thing that may come (in WORLD), 10 what is held (in
/// tool0), 11 a tool that may be left (in WORLD).
struct SceneModel {
    static constexpr std::size_t kBodies = 12;
    static constexpr std::size_t kSurroundings = 0;
    static constexpr std::size_t kFlange = 7;
    static constexpr std::size_t kTool = 8;
    static constexpr std::size_t kIntruder = 9;
    static constexpr std::size_t kObject = 10;
    static constexpr std::size_t kLeftTool = 11;
    std::array<Body, kBodies> bodies;
    Pose T_tool_grasp = Pose::Identity();  ///< where the gripper holds
};

/// Bodies that turn with joint 6.
[[nodiscard]] constexpr bool turns_with_joint6(std::size_t body) {
    return body == SceneModel::kFlange || body == SceneModel::kTool || body == SceneModel::kObject;
}

[[nodiscard]] std::array<Pose, SceneModel::kBodies> body_poses(const JointAngles& joints_rad);

struct SceneContents {
    std::string gripper;
    std::string object;
    bool with_arm = true;           ///< false: neither arm nor gripper
    double texture_contrast = 0.0;  ///< of gripper and object, relative to their brightness
    std::uint64_t seed = 1;
    Eigen::Vector3d gripper_centre_m = Eigen::Vector3d::Zero();  ///< in WORLD, for the fixtures
};

[[nodiscard]] SceneModel make_scene(const SceneContents& contents);

}  // namespace gripscan::sim
