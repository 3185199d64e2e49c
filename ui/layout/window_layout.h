// Where everything stands in the window. Pure: size, splitters and scale in, rectangles out.
#pragma once

#include <string_view>
#include <vector>

#include "ui/layout/rect.h"
#include "ui/layout/scale.h"

namespace gripscan::ui {

/// What the user dragged, in px at 100 %; nothing sensible (0, negative, huge) is clamped.
struct Splits {
    float stereo_width = 312.0F;
    float right_width = 380.0F;
    float bottom_height = 294.0F;
    friend bool operator==(const Splits&, const Splits&) = default;
};

/// The defaults for a window of this size: wider columns on a large monitor.
[[nodiscard]] Splits default_splits(int width_px, int height_px, Scale scale);

/// What had to give way in a small window.
struct Detail {
    bool stage_criteria = true;  ///< stages in two lines; else one line, criterion of the current
    bool tool_labels = true;     ///< words beside the icons of the 3D view
    bool log_is_a_tab = false;   ///< of the bottom dock, instead of a panel in the right column
    bool full_right_column = false;  ///< it runs down to the status bar, plot below the card
    bool stereo_is_a_tab = false;    ///< no room for the left column
    bool button_icons = true;        ///< on the buttons of the step card
    friend bool operator==(const Detail&, const Detail&) = default;
};

/// Every rectangle lies in the window; none overlaps another. A region that has no room is empty.
struct WindowLayout {
    Rect top_bar;
    Rect stage_bar;
    Rect stereo;
    Rect view3d;
    Rect step_card;
    Rect table;    ///< Table 1 and its tabs
    Rect history;  ///< error plot, and the log where it is no tab
    Rect status_bar;
    Rect splitter_stereo;  ///< between stereo and 3D view; drags stereo_width
    Rect splitter_right;   ///< left of the right column; drags right_width
    Rect splitter_bottom;  ///< above the dock; drags bottom_height
    Detail detail;
};

[[nodiscard]] WindowLayout layout_window(int width_px, int height_px, const Splits& splits,
                                         Scale scale);

enum class Splitter { kStereo, kRight, kBottom };

/// The splits after a splitter was dragged by some px; kept within what the window allows.
[[nodiscard]] Splits dragged(const Splits& splits, Splitter splitter, int by_px, int width_px,
                             int height_px, Scale scale);

}  // namespace gripscan::ui
