// The turn registration on prepared surfaces: what `align` does once normals and trees are there.
#pragma once

#include "core/registration/align.h"
#include "core/registration/surface.h"

namespace gripscan {

/// Cancelled is the only error. A pair that cannot be aligned gives found = false with a cause.
[[nodiscard]] Result<Alignment> align_surfaces(const Surface& source, const Surface& target,
                                               const AlignSettings& settings,
                                               const Progress& progress, const ForEach& for_each);

/// The final estimate from a pose that is nearly right, and everything that is known about it.
[[nodiscard]] Alignment finish_alignment(const Surface& source, const Surface& target,
                                         const Pose& start, const AlignSettings& settings);

/// The same for a pose that is given and kept: how well the surfaces fit there.
[[nodiscard]] Alignment alignment_at(const Surface& source, const Surface& target,
                                     const Pose& T_target_source, const AlignSettings& settings);

/// The verdict without a robot: is the pose tied down, is there only one, is there enough overlap?
void judge_alone(Alignment& alignment, const AlignSettings& settings);

}  // namespace gripscan
