// How far the points of each view lie from what the other views have measured: what is left of the
// registration, point by point, to look at.
#pragma once

#include <span>
#include <vector>

#include "core/base/for_each.h"
#include "core/registration/merge.h"

namespace gripscan {

/// Points farther from every other view than this lie where no other view has looked.
inline constexpr double kFarthestSeenAgain_m = 5.0e-3;
inline constexpr float kNotSeenAgain = -1.0F;

/// One list a view, one number a point, m: the distance along the normal to the nearest surface of
/// the `around` views before and after it in the list (which is taken as a circle, as a whole turn
/// is); kNotSeenAgain where none of them has a point within kFarthestSeenAgain_m. Clouds need
/// normals.
[[nodiscard]] std::vector<std::vector<float>> distances_to_other_views(
    std::span<const PosedView> views, std::size_t around, const ForEach& for_each);

}  // namespace gripscan
