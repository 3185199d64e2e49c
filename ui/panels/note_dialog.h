// Why something is accepted that gripscan did not accept.
#pragma once

#include "ui/layout/rect.h"
#include "ui/views/request.h"
#include "ui/views/snapshot.h"
#include "ui/widgets/ui.h"

namespace gripscan::ui {

struct NoteDialogState {
    std::string note;
};

/// In the middle of `screen`, the whole window; nothing behind it takes the mouse.
void draw_note_dialog(const Ui& ui, const Rect& screen, const Snapshot& snapshot,
                      NoteDialogState& local, Requests& out);

}  // namespace gripscan::ui
