// Pieces that several grippers share: the adapter to the flange, sensors, fittings, and the
// finishes they are made in.
#pragma once

#include <vector>

#include "core/sim/part.h"

namespace gripscan::sim {

[[nodiscard]] Material blasted_aluminium();
[[nodiscard]] Material blasted_steel();
[[nodiscard]] Material dark_plastic();
[[nodiscard]] Material light_plastic();

[[nodiscard]] Part box_part(const char* name, const Eigen::Vector3d& size_m,
                            const Eigen::Vector3d& centre_m, const Material& material,
                            double chamfer_m = 0.002);

/// Round plate and neck between the flange and whatever follows at z = 0.028.
[[nodiscard]] std::vector<Part> adapter();

/// A block with a lens, such as a small distance sensor; z of the frame is where it looks.
[[nodiscard]] std::vector<Part> sensor(const Pose& T_tool_sensor);

/// An elbow fitting with a stub of hose; it leaves the part along z of the frame, bends to x.
[[nodiscard]] std::vector<Part> hose_fitting(const Pose& T_tool_fitting);

}  // namespace gripscan::sim
