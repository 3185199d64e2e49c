// Numbers of the code in the units of the files, rounded to 1e-12 of the unit: 10° is 10 and not
// 10.000000000000002, and what is read back and written again is the same text.
#pragma once

#include <cmath>

#include "core/base/units.h"

namespace gripscan {

[[nodiscard]] inline double rounded_1e12(double value) {
    return std::round(value * 1e12) / 1e12;
}
[[nodiscard]] inline double file_deg(double rad) {
    return rounded_1e12(deg_from_rad(rad));
}
[[nodiscard]] inline double file_mm(double metres) {
    return rounded_1e12(metres * kMmPerM);
}

}  // namespace gripscan
