// The two streams: results on standard output, everything else on standard error.
#pragma once

#include <functional>
#include <string>
#include <string_view>

#include "app/context.h"

namespace gripscan::app {

/// The one JSON document of `--json`, or the text of a result.
void print_result(std::string_view text);
/// Did everything reach standard output so far? Its disk may be full.
[[nodiscard]] bool results_printed();
/// A remark for people; silent with --quiet.
void say(const Context& context, std::string_view text);
/// say() as a receiver of remarks; the context must outlive it.
[[nodiscard]] std::function<void(const std::string&)> remarks(const Context& context);
/// Reports the error and returns the exit status of its kind.
[[nodiscard]] ExitStatus report_error(const Error& error);

}  // namespace gripscan::app
