// The recent sessions on the start page: a searchable list, and where files are dropped.
#pragma once

#include "ui/panels/start_page.h"

namespace gripscan::ui {

void draw_recent_card(const Ui& ui, const Rect& card, const Snapshot& snapshot,
                      StartPageState& local, Requests& out);

}  // namespace gripscan::ui
