// What stands around the arm: table, wall, fixtures. Nothing of it moves.
#pragma once

#include <cstdint>
#include <vector>

#include "core/sim/part.h"

namespace gripscan::sim {

/// In FANUC WORLD, for a camera that looks along −y at the gripper at `gripper_m`. The seed moves
/// the fixtures about; wall, table and fixtures keep 0.17 m away from the gripper's centre line.
[[nodiscard]] std::vector<Part> make_environment(const Eigen::Vector3d& gripper_m,
                                                 std::uint64_t seed);

}  // namespace gripscan::sim
