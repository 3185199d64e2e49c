// How many threads a command uses.
#pragma once

#include "app/context.h"
#include "core/concurrency/worker_pool.h"

namespace gripscan::app {

[[nodiscard]] inline unsigned thread_count(const Context& context) {
    return context.options.threads.value_or(threads_wanted());
}

}  // namespace gripscan::app
