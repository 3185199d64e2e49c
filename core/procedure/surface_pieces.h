// A cloud taken apart into pieces of surface that do not touch.
#pragma once

#include <vector>

#include "core/cloud/cloud.h"
#include "core/procedure/cell_facts.h"

namespace gripscan {

/// Pieces are at least gap_m (> 2 mm) from each other; those of a smaller area are left out. The
/// largest comes first. Areas are counted in cubes of 2 mm: up to twice the true ones
/// where a surface lies across the cubes or between two layers of them.
[[nodiscard]] std::vector<Piece> pieces_of(const Cloud& cloud, double gap_m, double least_m2);

}  // namespace gripscan
