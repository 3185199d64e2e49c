// The keys of this frame as requests.
#pragma once

#include "ui/views/request.h"
#include "ui/views/snapshot.h"

namespace gripscan::ui {

/// After the panels were drawn: only then is it known which control has the keyboard.
/// Nothing while text is typed, a menu is open or a dialog has the keys. Space belongs to the next
/// action, unless the keyboard has been moved to a control.
void take_keys(const Snapshot& snapshot, Requests& out);

}  // namespace gripscan::ui
