// Writing the template: format, unit, frame, fields, and where to. The page beside it stays alive.
#pragma once

#include "ui/layout/rect.h"
#include "ui/views/request.h"
#include "ui/views/snapshot.h"
#include "ui/widgets/ui.h"

namespace gripscan::ui {

struct ExportDialogState {
    ExportWish wish;   ///< kept while the program runs
    std::string file;  ///< as it is typed
};

/// `beside` is the region the dialog may cover: the 3D view of the page.
void draw_export_dialog(const Ui& ui, const Rect& beside, const Snapshot& snapshot,
                        ExportDialogState& local, Requests& out);

}  // namespace gripscan::ui
