// Checks of numbers on the command line beyond their range: "nan" is in every range to CLI11, and
// "-1" becomes a huge whole number. They come before the range.
#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace gripscan::app {

/// A finite decimal number.
[[nodiscard]] CLI::Validator finite_number();
/// A whole number without a sign, to be given to transform(): it is rewritten without the leading
/// zeros that would make it octal to CLI11, which also takes what is too large for the largest.
[[nodiscard]] CLI::Validator unsigned_number();

}  // namespace gripscan::app
