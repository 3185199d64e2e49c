// The template's own column: which points of it are kept, and what they are like.
#pragma once

#include "ui/layout/rect.h"
#include "ui/views/request.h"
#include "ui/views/snapshot.h"
#include "ui/widgets/ui.h"

namespace gripscan::ui {

/// Where things stand on the page, the window between stage bar and status bar.
struct TemplatePageLayout {
    Rect view;    ///< the 3D view
    Rect column;  ///< right of it
};
[[nodiscard]] TemplatePageLayout template_page_layout(const Rect& page, Scale scale);

struct TemplatePageState {
    double last_sigmas = 1.5;  ///< what "Statistical" comes back to after "Off"
};

void draw_template_column(const Ui& ui, const Rect& column, const Snapshot& snapshot,
                          TemplatePageState& local, Requests& out);

}  // namespace gripscan::ui
