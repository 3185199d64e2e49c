// How the registration area lies in the two images and in the range of the stereo camera.
#pragma once

#include "core/geometry/box.h"
#include "core/geometry/stereo_rig.h"
#include "core/procedure/cell_facts.h"

namespace gripscan {

[[nodiscard]] VolumeFacts region_in_view(const Box& region, const RectifiedRig& rig);

}  // namespace gripscan
