// Can two surfaces tell one motion between them from another?
#pragma once

#include "core/registration/align.h"
#include "core/registration/surface.h"

namespace gripscan {

/// Do the surfaces and their patterns meet at `T_other` about as they do at `answer`? Then what
/// lies between the two is not resolved, whatever the noise foretells: a side that slides along
/// itself comes to rest further away than that.
[[nodiscard]] bool fits_as_well(const Surface& source, const Surface& target,
                                const Alignment& answer, const Pose& T_other,
                                const AlignSettings& settings);

}  // namespace gripscan
