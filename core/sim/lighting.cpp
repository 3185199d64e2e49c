#include "core/sim/lighting.h"

#include "core/base/seeded_random.h"

namespace gripscan::sim {

Lighting make_lighting(const Pose& T_world_camera, std::uint64_t seed) {
    SeededRandom random(seed);
    Lighting lighting;
    const auto panel = [&](const Eigen::Vector3d& place_in_camera_m, double strength) {
        Eigen::Vector3d place = place_in_camera_m;
        for (int i = 0; i < 3; ++i) place[i] += random.uniform(-0.08, 0.08);
        Lamp lamp;
        lamp.centre_m = (T_world_camera * place).cast<float>();
        lamp.half_u_m = (T_world_camera.linear() * Eigen::Vector3d(0.22, 0, 0)).cast<float>();
        lamp.half_v_m = (T_world_camera.linear() * Eigen::Vector3d(0, 0.04, 0.16)).cast<float>();
        lamp.strength = static_cast<float>(strength * random.uniform(0.92, 1.08));
        lighting.lamps.push_back(lamp);
    };
    // Camera frame: x right, y down, z forward.
    panel({-0.75, -0.95, 0.00}, 400.0);
    panel({0.85, -0.70, -0.10}, 215.0);
    lighting.ambient = static_cast<float>(140.0 * random.uniform(0.95, 1.05));
    return lighting;
}

}  // namespace gripscan::sim
