#include "core/sim/intruder.h"

namespace gripscan::sim {

Body make_intruder(double thickness_m, const Box& region, const Pose& T_world_camera,
                   std::uint64_t seed) {
    // The region's edge nearest to the camera and lowest is where a turning gripper never is.
    constexpr double kInside_m = 0.020;
    const double length_m = thickness_m;
    const double x = 0.35 * region.min_m.x() + 0.65 * region.max_m.x() - length_m;
    const Eigen::Vector3d end_m(x, region.max_m.y() - kInside_m, region.min_m.z() + kInside_m);
    const Pose T_camera_rod = frame_at(end_m, Eigen::Vector3d::UnitX());
    Material skin;
    skin.albedo = 0.55;
    skin.texture = {.cell_m = 0.012, .octaves = 4, .gain = 1.25, .contrast = 0.13};
    skin.texture.seed = static_cast<std::uint32_t>(seed);
    Body body;
    body.parts.push_back(
        {"intruder", moved(capsule(thickness_m / 2.0, length_m), T_world_camera * T_camera_rod),
         skin});
    return body;
}

}  // namespace gripscan::sim
