// Pieces of a view's surface that hang together in its image grid.
#pragma once

#include <vector>

#include "core/cloud/cloud.h"

namespace gripscan {

/// Of the points named by `among` (rising), those in pieces of fewer than `least` points.
/// Neighbours in the grid hang together when they are nearer than `gap_m`. Without a grid: none.
[[nodiscard]] std::vector<std::size_t> points_of_small_pieces(const Cloud& cloud,
                                                              const std::vector<std::size_t>& among,
                                                              std::size_t least, double gap_m);

}  // namespace gripscan
