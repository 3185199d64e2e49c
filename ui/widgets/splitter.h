// The edge between two regions that can be dragged; its hit area is wider than the line.
#pragma once

#include <string_view>

#include "ui/widgets/ui.h"

namespace gripscan::ui {

enum class SplitterWay { kLeftRight, kUpDown };

struct SplitterEvent {
    int moved_px = 0;    ///< since the frame before
    bool reset = false;  ///< double click: back to the default
};

[[nodiscard]] SplitterEvent splitter(const Ui& ui, const Rect& rect, std::string_view id,
                                     SplitterWay way);

}  // namespace gripscan::ui
