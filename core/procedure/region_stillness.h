// Whether two exposures show the registration area at rest.
#pragma once

#include "core/geometry/box.h"
#include "core/geometry/stereo_rig.h"
#include "core/procedure/exposure.h"

namespace gripscan {

/// Compares the rectified left images inside the region's image. Where nothing can be compared (no
/// texture, a region out of sight) the exposures count as agreeing: other checks name that.
[[nodiscard]] Result<StillnessTest> region_stillness(const StereoRig& rig,
                                                     const std::optional<Box>& region);

}  // namespace gripscan
