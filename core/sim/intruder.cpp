#include "core/sim/intruder.h"

#include <algorithm>

namespace gripscan::sim {
namespace {

/// The region's edge nearest to the camera and lowest is where a turning gripper never is.
constexpr double kInside_m = 0.020;

Material grained(double albedo, std::uint64_t seed) {
    Material material;
    material.albedo = albedo;
    material.texture = {.cell_m = 0.012, .octaves = 4, .gain = 1.25, .contrast = 0.13};
    material.texture.seed = static_cast<std::uint32_t>(seed);
    return material;
}

}  // namespace

Body make_intruder(double thickness_m, const Box& region, const Pose& T_world_camera,
                   std::uint64_t seed) {
    const double length_m = thickness_m;
    const double x = 0.35 * region.min_m.x() + 0.65 * region.max_m.x() - length_m;
    const double inside_m = std::max(kInside_m, 0.5 * thickness_m);  // all of it in the region
    const Eigen::Vector3d end_m(x, region.max_m.y() - inside_m, region.min_m.z() + inside_m);
    const Pose T_camera_rod = frame_at(end_m, Eigen::Vector3d::UnitX());
    const Material skin = grained(0.55, seed);
    Body body;
    body.parts.push_back(
        {"intruder", moved(capsule(thickness_m / 2.0, length_m), T_world_camera * T_camera_rod),
         skin});
    return body;
}

Body make_left_tool(double length_m, const Box& region, const Pose& T_world_camera,
                    std::uint64_t seed) {
    constexpr double kHandleRadius_m = 0.013;
    constexpr double kShaftRadius_m = 0.005;
    const double room_m = region.max_m.x() - region.min_m.x() - 2.0 * kInside_m;
    const double length = std::min(length_m, room_m);
    const Eigen::Vector3d end_m(region.min_m.x() + kInside_m + kHandleRadius_m,
                                region.max_m.y() - kInside_m, region.min_m.z() + kInside_m);
    const Pose T_world_end = T_world_camera * frame_at(end_m, Eigen::Vector3d::UnitX());
    const double handle_m = 0.45 * length - 2.0 * kHandleRadius_m;
    const double shaft_m = length - kHandleRadius_m - kShaftRadius_m;
    Body body;
    body.parts.push_back({"handle",
                          moved(capsule(kHandleRadius_m, std::max(0.001, handle_m)), T_world_end),
                          grained(0.42, seed)});
    body.parts.push_back(
        {"shaft", moved(capsule(kShaftRadius_m, shaft_m), T_world_end), grained(0.6, seed + 1)});
    return body;
}

}  // namespace gripscan::sim
