// Numbers as text in the C locale, whatever the user's locale is.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace gripscan {

/// Shortest text that reads back to the same double; "nan", "inf" and "-inf" for the others.
[[nodiscard]] std::string text_from_number(double value);

/// The whole text as a finite number (surrounding blanks allowed); nothing if it is anything else.
[[nodiscard]] std::optional<double> number_from_text(std::string_view text);

}  // namespace gripscan
