// The threads of the program: one pool, owned by whoever starts the work.
#pragma once

#include <memory>

#include "core/base/for_each.h"

namespace gripscan {

/// A fixed number of threads that share out the turns of a loop. The calling thread works too, so
/// a pool of one has no thread of its own. A loop started from inside a body runs in order on
/// that body's thread: nesting is safe and never deadlocks.
class WorkerPool {
  public:
    /// threads ≥ 1.
    explicit WorkerPool(unsigned threads);
    ~WorkerPool();
    WorkerPool(const WorkerPool&) = delete;
    WorkerPool& operator=(const WorkerPool&) = delete;

    [[nodiscard]] unsigned threads() const;

    /// The pool as a loop. Valid as long as the pool lives. The first exception of a body is
    /// thrown again in the caller, after all other turns have ended.
    [[nodiscard]] ForEach for_each();

  private:
    struct State;
    std::unique_ptr<State> state_;
};

/// GRIPSCAN_THREADS if it is a number from 1 to 1024, else the number of cores.
[[nodiscard]] unsigned threads_wanted();

}  // namespace gripscan
