// The first page: go on where one stopped, begin, open, or learn.
#pragma once

#include <optional>

#include "ui/layout/rect.h"
#include "ui/views/request.h"
#include "ui/views/snapshot.h"
#include "ui/widgets/ui.h"

namespace gripscan::ui {

struct StartPageState {
    std::string search;
    std::optional<std::filesystem::path> menu;  ///< the session whose menu is open
};

/// Fills `rect`, the window between its bars. Takes S O N G and Space while no dialog is open.
void draw_start_page(const Ui& ui, const Rect& rect, const Snapshot& snapshot,
                     StartPageState& local, Requests& out);

}  // namespace gripscan::ui
