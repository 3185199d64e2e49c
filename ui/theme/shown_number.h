// Numbers as the screen shows them.
#pragma once

#include <string>

namespace gripscan::ui {

/// A number as it is shown: fixed decimals, U+2212 as minus, an explicit plus on request.
enum class Sign { kMinusOnly, kAlways };
[[nodiscard]] std::string shown_number(double value, int decimals, Sign sign = Sign::kMinusOnly);
/// Thousands parted by blanks that do not break (the face of numbers has no thin ones).
[[nodiscard]] std::string shown_count(long long count);

}  // namespace gripscan::ui
