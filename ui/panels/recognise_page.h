// The Recognise page: one view, the templates found in it, their poses and what they rest on.
#pragma once

#include <string>

#include "ui/layout/window_layout.h"
#include "ui/panels/stereo_panel.h"
#include "ui/panels/view3d_panel.h"

namespace gripscan::ui {

/// Where things stand on the page, the window between stage bar and status bar.
struct RecognisePageLayout {
    Rect image;   ///< left image with the cuboids; empty: no room
    Rect view;    ///< the 3D view
    Rect poses;   ///< the table below both
    Rect column;  ///< right of all
};
[[nodiscard]] RecognisePageLayout recognise_page_layout(const Rect& page, const Splits& splits,
                                                        Scale scale);

struct RecognisePageState {
    StereoPanelState image;
    std::string to_remove;  ///< template of the library that is asked about; empty: none
};

/// All but the 3D view. `textures` null: only the words are drawn (no OpenGL).
void draw_recognise_page(const Ui& ui, const RecognisePageLayout& places, const Snapshot& snapshot,
                         StereoTextures* textures, RecognisePageState& local, Requests& out);

}  // namespace gripscan::ui
