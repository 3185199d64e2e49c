#include "app/number_checks.h"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <cstdint>
#include <limits>

namespace gripscan::app {

CLI::Validator finite_number() {
    const auto problem = [](std::string& text) -> std::string {
        double number = 0.0;
        if (CLI::detail::lexical_cast(text, number) && std::isfinite(number)) return {};
        return fmt::format("'{}' is not a finite number", text);
    };
    return {problem, ""};
}

CLI::Validator unsigned_number() {
    const auto problem = [](std::string& text) -> std::string {
        std::uint64_t number = 0;
        const char* end = text.data() + text.size();
        const auto read = std::from_chars(text.data(), end, number);
        if (read.ptr != end || read.ec == std::errc::invalid_argument) {
            return fmt::format("'{}' is not a whole number from 0 on", text);
        }
        if (read.ec != std::errc{}) {
            return fmt::format("'{}' is too large, at most {} can be given", text,
                               std::numeric_limits<std::uint64_t>::max());
        }
        text = fmt::format("{}", number);
        return {};
    };
    return {problem, ""};
}

}  // namespace gripscan::app
