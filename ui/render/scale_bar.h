// The scale bar of the 3D view: a round length that is about as long as wanted.
#pragma once

namespace gripscan::ui {

struct ScaleBar {
    double length_mm = 0.0;  ///< 1, 2 or 5 times a power of ten
    double length_px = 0.0;  ///< at most what was wanted, more than 0.39 of it
};

/// At the depth where one metre has `px_per_m` pixels.
[[nodiscard]] ScaleBar scale_bar(double px_per_m, double wanted_px);

}  // namespace gripscan::ui
