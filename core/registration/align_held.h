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

/// As align_surfaces(), with two more witnesses. The texture may show the turn of a part whose
/// shape does not. And the gripper's motion, measured in the same two pictures where its shape
/// shows it: a plain side slides along itself and is seen in part only, so that the search may come
/// to rest beside the answer. It is another start, for which texture may speak; and where the part
/// fits as well to it as to what was found, the part is taken to have moved with it.
[[nodiscard]] Result<Alignment> align_held(const HeldSurface& source, const HeldSurface& target,
                                           const AlignSettings& settings, const Progress& progress,
                                           const ForEach& for_each);

}  // namespace gripscan
