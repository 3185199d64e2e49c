// What colours the clouds: a field that opens a list, with the reason at those that are not to be
// had.
#pragma once

#include "ui/panels/view3d_state.h"
#include "ui/widgets/ui.h"

namespace gripscan::ui {

/// What is shown now: the user's choice, where it can be had, else what suits the scene.
[[nodiscard]] ColourBy shown_colouring(const SceneParts& parts, const View3dState& state);

/// Opens "view3d.colour"; its entries are "view3d.colour.step", …, "view3d.colour.pair".
void draw_colour_menu(const Ui& ui, const Rect& rect, const Snapshot& snapshot,
                      const SceneParts& parts, View3dState& state);

}  // namespace gripscan::ui
