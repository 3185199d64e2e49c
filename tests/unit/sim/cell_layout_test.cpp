#include "core/sim/cell_layout.h"

#include <gtest/gtest.h>

#include "core/base/units.h"
#include "core/sim/grippers.h"
#include "core/sim/objects.h"
#include "core/sim/surface_samples.h"
#include "tests/unit/sim/small_cell.h"

namespace gripscan::sim {
namespace {

Box grown(const Box& box, double by_m) {
    return {box.min_m - Eigen::Vector3d::Constant(by_m),
            box.max_m + Eigen::Vector3d::Constant(by_m)};
}

struct Case {
    std::uint64_t seed;
    std::string gripper;
    std::string object;
};

/// Every gripper, every object in some gripper, eleven seeds.
std::vector<Case> cases() {
    std::vector<Case> result;
    std::uint64_t seed = 1;
    for (const auto& gripper : gripper_names()) result.push_back({seed++, gripper, ""});
    for (const auto& object : object_names()) result.push_back({seed++, "two-finger", object});
    result.push_back({seed++, "suction", "carton"});
    return result;
}

class Region : public ::testing::TestWithParam<Case> {
  protected:
    void SetUp() override {
        layout = make_layout(GetParam().seed);
        SceneContents contents;
        contents.gripper = GetParam().gripper;
        contents.object = GetParam().object;
        contents.seed = GetParam().seed;
        contents.gripper_centre_m = body_poses(layout.joints_rad)[SceneModel::kTool] *
                                    Eigen::Vector3d(0, 0, kGripperCentre_m);
        model = make_scene(contents);
        region = registration_area(layout, model);
    }
    CellLayout layout;
    SceneModel model;
    Box region;
};

TEST_P(Region, HoldsWhatTurnsAtEveryAngle) {
    const Pose T_camera_world = layout.T_world_camera.inverse();
    Box inside = grown(region, -0.0199);
    inside.max_m.x() = region.max_m.x();
    JointAngles q = layout.joints_rad;
    for (int step = 0; step < 24; ++step) {
        q[5] = rad_from_deg(15.0 * step - 180.0);
        const Pose T_camera_tool = T_camera_world * body_poses(q)[SceneModel::kTool];
        for (const Part& part : model.bodies[SceneModel::kTool].parts) {
            for (const Eigen::Vector3d& v : part.mesh.vertices) {
                // Before the adapter plate; on the arm's side the margin is the arm's.
                if (v.z() < 0.015) continue;
                EXPECT_TRUE(inside.contains(T_camera_tool * v)) << part.name;
            }
        }
    }
}

TEST_P(Region, IsFarFromEverythingElse) {
    const Pose T_camera_world = layout.T_world_camera.inverse();
    const auto T_world_body = body_poses(layout.joints_rad);
    for (std::size_t body = 0; body < SceneModel::kBodies; ++body) {
        if (turns_with_joint6(body)) continue;
        for (const Part& part : model.bodies[body].parts) {
            for (const SurfaceSample& sample : sample_surface(part.mesh, 0.01)) {
                EXPECT_FALSE(grown(region, 0.0199)
                                 .contains(T_camera_world * T_world_body[body] * sample.point_m))
                    << part.name;
            }
        }
    }
}

TEST_P(Region, IsSeenByBothCameras) {
    for (const auto& [K, D, T_world_eye] :
         {std::tuple{layout.rig.K_left, layout.rig.D_left, layout.T_world_left()},
          std::tuple{layout.rig.K_right, layout.rig.D_right, layout.T_world_right()}}) {
        const Lens lens(K, D, layout.rig.image);
        for (const Eigen::Vector3d& corner : region.corners()) {
            const Eigen::Vector2d p =
                lens.project(T_world_eye.inverse() * layout.T_world_camera * corner);
            EXPECT_GT(p.x(), 5.0);
            EXPECT_GT(p.y(), 5.0);
            EXPECT_LT(p.x(), layout.rig.image.width - 5.0);
            EXPECT_LT(p.y(), layout.rig.image.height - 5.0);
        }
    }
}

std::string name_of(const ::testing::TestParamInfo<Case>& test) {
    return "seed" + std::to_string(test.param.seed);
}

INSTANTIATE_TEST_SUITE_P(AllParts, Region, ::testing::ValuesIn(cases()), name_of);

TEST(CellLayout, IsTheDefaultCellOfTheIssue) {
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
        const CellLayout layout = make_layout(seed);
        EXPECT_TRUE(validate(layout.rig));
        EXPECT_FALSE(layout.rig.is_rectified());
        EXPECT_EQ(layout.rig.image, (ImageSize{1280, 960}));
        EXPECT_EQ(layout.rig.K_left(0, 0), 985.0);
        EXPECT_NEAR(layout.rig.baseline_m(), 0.12, 1e-12);
        const Axis axis = joint6_axis_in_camera(layout);
        EXPECT_LT(deg_from_rad(std::acos(axis.direction.x())), 6.0);
        const Eigen::Vector3d gripper_m = axis.point_m - axis.direction * 0.085;
        EXPECT_NEAR(gripper_m.z(), 0.74, 0.0151);
    }
}

TEST(CellLayout, SeedsMoveTheCamera) {
    const Pose a = make_layout(1).T_world_camera;
    const Pose b = make_layout(2).T_world_camera;
    EXPECT_GT(rotation_angle_rad(a.linear().transpose() * b.linear()), rad_from_deg(0.1));
    EXPECT_TRUE(a.isApprox(make_layout(1).T_world_camera, 0.0));
}

}  // namespace
}  // namespace gripscan::sim
