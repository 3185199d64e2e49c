#include "core/sim/scene_model.h"

#include "core/robot/kinematics.h"
#include "core/sim/arm_model.h"
#include "core/sim/environment.h"
#include "core/sim/grippers.h"
#include "core/sim/objects.h"
#include "core/sim/seeds.h"

namespace gripscan::sim {
namespace {

/// A blasted, speckled surface: grain from 1.5 mm (two pixels at the default distance) to 12 mm.
Texture grain(double contrast) {
    return {.cell_m = 0.012, .octaves = 4, .gain = 1.25, .contrast = contrast};
}

/// The gripper and what it holds.
void mount(const SceneContents& contents, SceneModel& model) {
    const Gripper gripper = make_gripper(contents.gripper);
    model.T_tool_grasp = gripper.T_tool_grasp;
    std::vector<Part>& tool = model.bodies[SceneModel::kTool].parts;
    std::vector<Part>& held = model.bodies[SceneModel::kObject].parts;
    tool = gripper.parts;
    if (!contents.object.empty()) held = make_object(contents.object, gripper.opening_m);
    for (Part& part : held) part.mesh = moved(part.mesh, gripper.T_tool_grasp);
    for (std::vector<Part>* parts : {&tool, &held}) {
        for (Part& part : *parts) part.material.texture = grain(contents.texture_contrast);
    }
}

}  // namespace

std::array<Pose, SceneModel::kBodies> body_poses(const JointAngles& joints_rad) {
    std::array<Pose, SceneModel::kBodies> T_world_body;
    T_world_body[SceneModel::kSurroundings] = Pose::Identity();
    const auto T_world_link = link_poses(joints_rad);
    for (std::size_t i = 0; i < T_world_link.size(); ++i) T_world_body[1 + i] = T_world_link[i];
    T_world_body[SceneModel::kTool] = tool_pose(joints_rad);
    T_world_body[SceneModel::kIntruder] = Pose::Identity();
    T_world_body[SceneModel::kLeftTool] = Pose::Identity();
    T_world_body[SceneModel::kObject] = T_world_body[SceneModel::kTool];
    return T_world_body;
}

SceneModel make_scene(const SceneContents& contents) {
    SceneModel model;
    model.bodies[SceneModel::kSurroundings].parts =
        make_environment(contents.gripper_centre_m, seed_for(contents.seed, Use::kFixtures));
    if (contents.with_arm) {
        auto arm = make_arm();
        for (std::size_t i = 0; i < arm.size(); ++i) model.bodies[1 + i].parts = std::move(arm[i]);
        mount(contents, model);
    }
    std::uint64_t number = 0;
    for (Body& body : model.bodies) {
        for (Part& part : body.parts) {
            part.material.texture.seed =
                static_cast<std::uint32_t>(seed_for(contents.seed, Use::kTexture, number++));
        }
    }
    return model;
}

}  // namespace gripscan::sim
