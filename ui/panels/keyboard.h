// The keys of this frame as requests.
#pragma once

#include "ui/views/request.h"
#include "ui/views/snapshot.h"

namespace gripscan::ui {

/// After the panels were drawn: only then is it known which control has the keyboard.
/// Nothing while text is typed or a menu is open; over a dialog only what stops the arm. Space
/// belongs to the next action, unless the keyboard has been moved to a control. `escape_taken`: Esc
/// has ended something else in this frame.
void take_keys(const Snapshot& snapshot, bool escape_taken, Requests& out);

}  // namespace gripscan::ui
