// Commands as a person can paste them.
#pragma once

#include <string>
#include <string_view>

namespace gripscan::app {

/// One word of a shell's command line, in quotes where it needs them.
[[nodiscard]] std::string shell_word(std::string_view text);

}  // namespace gripscan::app
