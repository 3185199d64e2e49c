// A new session: which cell, where it is kept, how it turns.
#pragma once

#include "ui/layout/rect.h"
#include "ui/views/request.h"
#include "ui/views/session_wish.h"
#include "ui/views/snapshot.h"
#include "ui/widgets/ui.h"

namespace gripscan::ui {

/// Kept while the program runs. `simulated` is set from request::Show::cell_file when it is opened.
struct NewSessionState {
    TypedSession typed;
};

/// In the middle of `screen`, the whole window; nothing behind it takes the mouse.
void draw_new_session_dialog(const Ui& ui, const Rect& screen, const Snapshot& snapshot,
                             NewSessionState& local, Requests& out);

}  // namespace gripscan::ui
