// The arm as solids: proportions of the LR Mate 200iC/5L, drawn link by link.
#pragma once

#include <array>
#include <vector>

#include "core/sim/part.h"

namespace gripscan::sim {

/// Parts of the base (0) and of links 1 … 6, each in the frame of its link (robot/kinematics.h).
[[nodiscard]] std::array<std::vector<Part>, 7> make_arm();

}  // namespace gripscan::sim
