#include "ui/render/scale_bar.h"

#include <cmath>

namespace gripscan::ui {

ScaleBar scale_bar(double px_per_m, double wanted_px) {
    if (!(px_per_m > 0.0) || !(wanted_px > 0.0)) return {};
    const double px_per_mm = px_per_m / 1000.0;
    const double longest_mm = wanted_px / px_per_mm;
    const double power = std::pow(10.0, std::floor(std::log10(longest_mm)));
    const double lead = longest_mm / power;
    const double length_mm = (lead >= 5.0 ? 5.0 : lead >= 2.0 ? 2.0 : 1.0) * power;
    return {length_mm, length_mm * px_per_mm};
}

}  // namespace gripscan::ui
