// The cell's lamps. They and the camera stand still, so the shading of a part changes as it turns.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "core/geometry/pose.h"

namespace gripscan::sim {

/// A panel that shines to all sides alike.
struct Lamp {
    Eigen::Vector3f centre_m;
    Eigen::Vector3f half_u_m;
    Eigen::Vector3f half_v_m;
    float strength = 0.0F;  ///< brightness (levels) of a white surface facing it from 1 m
};

struct Lighting {
    std::vector<Lamp> lamps;
    float ambient = 0.0F;  ///< levels of a white surface, from everywhere
    Eigen::Vector3f up = Eigen::Vector3f::UnitZ();
};

/// Two panels above and in front of the camera's field, in WORLD; the seed varies place and
/// strength by some per cent.
[[nodiscard]] Lighting make_lighting(const Pose& T_world_camera, std::uint64_t seed);

}  // namespace gripscan::sim
