#include "ui/theme/shown_number.h"

#include <fmt/format.h>

#include <cmath>

namespace gripscan::ui {

std::string shown_number(double value, int decimals, Sign sign) {
    if (!std::isfinite(value)) return "–";
    std::string text = fmt::format("{:.{}f}", std::abs(value), decimals);
    const bool zero = text.find_first_not_of("0.") == std::string::npos;
    if (value < 0.0 && !zero) return "−" + text;
    return sign == Sign::kAlways ? "+" + text : text;
}

std::string shown_count(long long count) {
    std::string digits = fmt::format("{}", count < 0 ? -count : count);
    std::string text;
    for (std::size_t i = 0; i < digits.size(); ++i) {
        if (i > 0 && (digits.size() - i) % 3 == 0) text += "\u2009";
        text += digits[i];
    }
    return count < 0 ? "−" + text : text;
}

}  // namespace gripscan::ui
