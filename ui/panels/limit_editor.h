// The limit of a line of evidence, edited where it is shown: a small card beside the line.
#pragma once

#include <string>
#include <string_view>

#include "ui/layout/rect.h"
#include "ui/views/request.h"
#include "ui/views/snapshot.h"
#include "ui/widgets/ui.h"

namespace gripscan::ui {

struct LimitEditorState {
    std::string evidence;  ///< "evidence.overlap": whose limit is edited
    Rect row;              ///< its line, below which the card opens
};

/// For the line that was clicked; nothing happens where its limit is fixed.
void open_limit_editor(LimitEditorState& local, const Snapshot& snapshot, std::string_view evidence,
                       const Rect& row);

/// Draws it while it is open.
void draw_limit_editor(const Ui& ui, const Snapshot& snapshot, const LimitEditorState& local,
                       Requests& out);

}  // namespace gripscan::ui
