// What the images of a capture say about it, and whether it stands out from its neighbours: a
// frame with glare or out of focus is named before its cloud is blamed.
#pragma once

#include <optional>
#include <span>
#include <string>

#include "core/registration/verdict.h"

namespace gripscan {

/// Inside the image of the registration area.
struct ImageHealth {
    double fill = 0.0;       ///< share of textured pixels with a disparity
    double glare = 0.0;      ///< share of pixels at the upper end of the scale
    double contrast = 0.0;   ///< of the surface, standard deviation, levels
    double sharpness = 0.0;  ///< fine structure over coarse structure
};

/// A capture that stands out: by what, and how far (1 = on the limit).
struct ImageFault {
    Cause cause = Cause::kNone;  ///< exposure or texture
    double excess = 0.0;
    std::string sentence;  ///< value, limit, reason; without the capture
    bool hurts = false;    ///< so much is missing that the capture is no witness
};

/// Compares a capture with the median of the others (those with images; at least two, else only
/// what is wrong by itself counts). Nothing if it does not stand out.
[[nodiscard]] std::optional<ImageFault> image_fault(const ImageHealth& capture,
                                                    std::span<const ImageHealth> others);

}  // namespace gripscan
