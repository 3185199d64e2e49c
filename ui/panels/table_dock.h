// The dock below: Table 1, the images of the selected step, all attempts, and the log where it has
// no panel of its own.
#pragma once

#include "ui/layout/window_layout.h"
#include "ui/panels/log_list.h"
#include "ui/panels/picture_cache.h"
#include "ui/views/table_text.h"

namespace gripscan::ui {

enum class DockTab { kTable, kImages, kAttempts, kLog };

struct TableDockState {
    DockTab tab = DockTab::kTable;
    TableView view = TableView::kRobotAgainstIcp;
    std::optional<std::size_t> menu_row;  ///< of Table 1, whose menu is open
};

/// `pictures` null: images are not drawn (no OpenGL).
void draw_table_dock(const Ui& ui, const Rect& rect, const Snapshot& snapshot, const Detail& detail,
                     TableDockState& local, LogListState& log, PictureCache* pictures,
                     Requests& out);

}  // namespace gripscan::ui
