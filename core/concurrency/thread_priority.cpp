#include "core/concurrency/thread_priority.h"

#include <sys/resource.h>
#include <unistd.h>

namespace gripscan {

void work_in_background() {
    // On Linux the niceness of a thread is its own, and its children inherit it.
    constexpr int kNiceness = 10;
    (void)::setpriority(PRIO_PROCESS, static_cast<id_t>(::gettid()), kNiceness);
}

}  // namespace gripscan
