// Opening a session folder or a cloud by its path.
#pragma once

#include "ui/layout/rect.h"
#include "ui/views/path_listing.h"
#include "ui/views/request.h"
#include "ui/views/snapshot.h"
#include "ui/widgets/ui.h"

namespace gripscan::ui {

struct OpenDialogState {
    std::string path;     ///< as it is typed
    PathListing listing;  ///< of the folder that is typed
};

/// In the middle of `screen`, the whole window; nothing behind it takes the mouse.
void draw_open_dialog(const Ui& ui, const Rect& screen, const Snapshot& snapshot,
                      OpenDialogState& local, Requests& out);

}  // namespace gripscan::ui
