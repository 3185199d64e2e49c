// How much the patterns of two views differ at a pose.
#pragma once

#include <optional>

#include "core/registration/align.h"
#include "core/registration/surface.h"

namespace gripscan {

/// Median over the places that both views see, in local deviations, at a scale of texture_rows();
/// nothing where they show too little.
[[nodiscard]] std::optional<double> texture_difference(const Surface& source, const Surface& target,
                                                       const Alignment& at, int scale);

}  // namespace gripscan
