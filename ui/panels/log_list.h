// The log: level filter, search, copy, and the lines, the newest at the bottom.
#pragma once

#include <array>

#include "ui/views/request.h"
#include "ui/views/snapshot.h"
#include "ui/widgets/ui.h"

namespace gripscan::ui {

struct LogListState {
    LogLevel least = LogLevel::kInformation;
    bool searching = false;
    std::array<char, 64> search{};
};

void draw_log_list(const Ui& ui, const Rect& rect, const Snapshot& snapshot, LogListState& local,
                   Requests& out);

}  // namespace gripscan::ui
