// The strange thing in the registration area: what a hand or a tool left there would look like.
#pragma once

#include "core/geometry/box.h"
#include "core/sim/scene_model.h"

namespace gripscan::sim {

/// A rod of this thickness, twice as long, in WORLD, inside the region (camera frame) before
/// and below what turns there, clear of it.
[[nodiscard]] Body make_intruder(double thickness_m, const Box& region, const Pose& T_world_camera,
                                 std::uint64_t seed);

/// A screwdriver of this length (shorter if the region is), lying along the region's lower edge
/// nearest to the camera; in WORLD.
[[nodiscard]] Body make_left_tool(double length_m, const Box& region, const Pose& T_world_camera,
                                  std::uint64_t seed);

}  // namespace gripscan::sim
