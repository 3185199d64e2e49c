// What every subcommand gets: how to speak, how many threads, when to stop.
#pragma once

#include <functional>
#include <optional>
#include <stop_token>
#include <string>

#include "core/base/result.h"

namespace gripscan::app {

/// Exit statuses of the contract.
enum ExitStatus : int {
    kDone = 0,
    kNotTrusted = 1,
    kWrongInput = 2,
    kDeviceFailed = 3,
    kCancelled = 4,
};

/// The options that every subcommand takes.
struct CommonOptions {
    bool json = false;
    bool quiet = false;
    std::optional<unsigned> threads;
};

struct Context {
    CommonOptions options;
    std::stop_token stop;
};

/// Set by the subcommand that was chosen; run once everything is parsed.
using Action = std::function<Result<ExitStatus>(const Context&)>;

}  // namespace gripscan::app
