// Which threads wait for which when the processor is busy.
#pragma once

namespace gripscan {

/// The calling thread, and every thread it starts from now on, lets ordinary threads go first.
/// There is no way back for an ordinary user's thread. Where the system refuses it, nothing
/// changes.
void work_in_background();

}  // namespace gripscan
