// Where a template ends although the part may go on: at the rim of what was seen of it, or where
// the registration area cut it off.
#pragma once

#include <vector>

#include "core/base/for_each.h"
#include "core/recognition/oriented_points.h"

namespace gripscan {

/// One flag a point: around it, in the plane of its neighbours, a wide sector is empty. Edges and
/// thin walls of a closed surface have neighbours on all sides. spacing_m: of the points.
[[nodiscard]] std::vector<char> open_border(const OrientedPoints& part, double spacing_m,
                                            const ForEach& for_each);

}  // namespace gripscan
