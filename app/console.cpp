#include "app/console.h"

#include <fmt/format.h>

#include <cstdio>

#include "app/standard_streams.h"

namespace gripscan::app {

void print_result(std::string_view text) {
    std::fwrite(text.data(), 1, text.size(), stdout);
    std::fflush(stdout);
}

bool results_printed() {
    return std::fflush(stdout) == 0 && std::ferror(stdout) == 0;
}

void say(const Context& context, std::string_view text) {
    if (!context.options.quiet) tell_people(fmt::format("gripscan: {}\n", text));
}

std::function<void(const std::string&)> remarks(const Context& context) {
    return [&context](const std::string& text) { say(context, text); };
}

ExitStatus report_error(const Error& error) {
    tell_people(fmt::format("gripscan: {}\n", error.message));
    switch (error.kind) {
        case ErrorKind::kInput:
            return kWrongInput;
        case ErrorKind::kDevice:
            return kDeviceFailed;
        case ErrorKind::kCancelled:
            return kCancelled;
        case ErrorKind::kRejected:
            return kNotTrusted;
    }
    return kWrongInput;
}

}  // namespace gripscan::app
