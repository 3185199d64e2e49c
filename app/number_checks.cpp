#include "app/number_checks.h"

#include <fmt/format.h>

#include <cmath>

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
        if (!text.empty() && text.find_first_not_of("0123456789") == std::string::npos) return {};
        return fmt::format("'{}' is not a whole number from 0 on", text);
    };
    return {problem, ""};
}

}  // namespace gripscan::app
