// A new session: which cell, where it is kept, how it turns.
#pragma once

#include "ui/layout/rect.h"
#include "ui/views/request.h"
#include "ui/views/snapshot.h"
#include "ui/widgets/ui.h"

namespace gripscan::ui {

struct NewSessionState {
    SessionWish wish;
    std::string folder;  ///< as it is typed
    std::string cell_file;
    bool simulated = true;
    std::string fault;  ///< that is chosen to be added
};

/// In the middle of `screen`, the whole window; nothing behind it takes the mouse.
void draw_new_session_dialog(const Ui& ui, const Rect& screen, const Snapshot& snapshot,
                             NewSessionState& local, Requests& out);

}  // namespace gripscan::ui
