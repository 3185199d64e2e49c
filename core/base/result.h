// Expected failures are values: Result<T> carries either the value or an Error that says what
// failed, where, why and what to do. Exceptions stay for broken invariants.
#pragma once

#include <fmt/format.h>

#include <string>
#include <tl/expected.hpp>
#include <utility>

namespace gripscan {

enum class ErrorKind {
    kInput,      ///< wrong usage, or a file that cannot be read or makes no sense
    kDevice,     ///< camera, robot or link
    kCancelled,  ///< the user asked to stop
    kRejected,   ///< done, but the result is over its limit and was not kept
};

struct Error {
    ErrorKind kind = ErrorKind::kInput;
    std::string message;  ///< one line, complete without context: what, where, why, what to do
};

template <typename T>
using Result = tl::expected<T, Error>;
using Status = Result<void>;

template <typename... Args>
[[nodiscard]] tl::unexpected<Error> input_error(fmt::format_string<Args...> text, Args&&... args) {
    return tl::unexpected<Error>(
        Error{ErrorKind::kInput, fmt::format(text, std::forward<Args>(args)...)});
}

template <typename... Args>
[[nodiscard]] tl::unexpected<Error> device_error(fmt::format_string<Args...> text, Args&&... args) {
    return tl::unexpected<Error>(
        Error{ErrorKind::kDevice, fmt::format(text, std::forward<Args>(args)...)});
}

[[nodiscard]] inline tl::unexpected<Error> cancelled_error() {
    return tl::unexpected<Error>(Error{ErrorKind::kCancelled, "cancelled"});
}

[[nodiscard]] inline tl::unexpected<Error> forward_error(Error error) {
    return tl::unexpected<Error>(std::move(error));
}

}  // namespace gripscan
