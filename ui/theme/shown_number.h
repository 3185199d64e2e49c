// Numbers as the screen shows them.
#pragma once

#include <string>

namespace gripscan::ui {

/// A number as it is shown: fixed decimals, U+2212 as minus, an explicit plus on request.
enum class Sign { kMinusOnly, kAlways };
[[nodiscard]] std::string shown_number(double value, int decimals, Sign sign = Sign::kMinusOnly);
/// Thousands parted by thin spaces.
[[nodiscard]] std::string shown_count(long long count);

}  // namespace gripscan::ui
