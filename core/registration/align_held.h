// Registration of what is held: found as anything is, and once more from how its gripper moved.
#pragma once

#include "core/registration/align.h"
#include "core/registration/holder.h"

namespace gripscan {

/// A held part in one view, with what holds it there.
struct HeldSurface {
    const Surface& part;
    const Holder& holder;  ///< usable
};

/// As align_surfaces(). A plain side slides along itself and is seen in part only, so that the
/// search may come to rest beside the answer; then the motion of the gripper, measured in the same
/// two pictures and only where its shape shows it, is another start, and the texture decides between
/// the two.
[[nodiscard]] Result<Alignment> align_held(const HeldSurface& source, const HeldSurface& target,
                                           const AlignSettings& settings, const Progress& progress,
                                           const ForEach& for_each);

}  // namespace gripscan
