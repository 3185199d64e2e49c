#include "core/sim/environment.h"

#include "core/base/seeded_random.h"

namespace gripscan::sim {
namespace {

using Eigen::Vector3d;

Material matte(double albedo, double cell_m, double contrast) {
    Material material;
    material.albedo = albedo;
    material.texture = {.cell_m = cell_m, .octaves = 5, .gain = 0.85, .contrast = contrast};
    return material;
}

Part block(const char* name, const Vector3d& size_m, const Vector3d& centre_m,
           const Material& material, double turn_rad = 0.0) {
    Pose T = frame_at(centre_m);
    T.linear() = Eigen::AngleAxisd(turn_rad, Vector3d::UnitZ()).toRotationMatrix();
    return {name, moved(chamfered_box(size_m, 0.003), T), material};
}

constexpr double kTableDrop_m = 0.29;  ///< table top below the gripper
constexpr double kWallBehind_m = 0.95;

std::vector<Part> table_and_wall(const Vector3d& gripper_m) {
    const double top_z = gripper_m.z() - kTableDrop_m;
    const double wall_y = gripper_m.y() - kWallBehind_m;
    return {
        block("table", {1.20, 0.82, 0.04}, gripper_m + Vector3d(0.15, -0.22, -kTableDrop_m - 0.02),
              matte(0.44, 0.030, 0.16)),
        block("wall", {5.0, 0.05, 3.0}, {gripper_m.x(), wall_y - 0.025, top_z + 0.6},
              matte(0.58, 0.080, 0.14)),
        block("floor", {5.0, 4.0, 0.05}, {gripper_m.x(), wall_y + 2.0, -0.355},
              matte(0.36, 0.060, 0.14)),
        block("panel", {0.62, 0.03, 0.50}, {gripper_m.x() + 0.34, wall_y + 0.015, top_z + 0.52},
              matte(0.42, 0.040, 0.12)),
        block("duct", {2.4, 0.06, 0.07}, {gripper_m.x(), wall_y + 0.03, top_z + 0.88},
              matte(0.66, 0.040, 0.10))};
}

}  // namespace

std::vector<Part> make_environment(const Vector3d& gripper_m, std::uint64_t seed) {
    SeededRandom random(seed);
    std::vector<Part> parts = table_and_wall(gripper_m);
    const Vector3d table_m = gripper_m - Vector3d(0, 0, kTableDrop_m);
    const auto at = [&](double x, double y, double height) -> Vector3d {
        return table_m + Vector3d(x + random.uniform(-0.03, 0.03), y + random.uniform(-0.03, 0.03),
                                  height / 2.0);
    };
    parts.push_back(block("vice", {0.12, 0.10, 0.09}, at(0.22, -0.16, 0.09),
                          matte(0.30, 0.016, 0.14), random.uniform(-0.4, 0.4)));
    parts.push_back(block("crate", {0.16, 0.12, 0.15}, at(-0.22, -0.30, 0.15),
                          matte(0.54, 0.024, 0.14), random.uniform(-0.5, 0.5)));
    parts.push_back(
        block("profile", {0.04, 0.04, 0.62}, at(0.44, -0.42, 0.62), matte(0.60, 0.016, 0.08)));
    parts.push_back({"roll",
                     moved(cylinder(0.045, 0.0, 0.11, 0.004), frame_at(at(-0.02, -0.40, 0.0))),
                     matte(0.48, 0.020, 0.16)});
    parts.push_back({"nest",
                     moved(lathe({{0.055, 0.0}, {0.055, 0.020}, {0.030, 0.034}, {0.030, 0.060}}),
                           frame_at(at(0.02, -0.02, 0.0))),
                     matte(0.40, 0.012, 0.14)});
    return parts;
}

}  // namespace gripscan::sim
