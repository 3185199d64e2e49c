// States by shape, word and colour, so that each alone tells them: disc with tick, triangle with
// bar, octagon with cross, ring with a filled third, dashed ring.
#pragma once

#include "ui/theme/state.h"
#include "ui/widgets/ui.h"

namespace gripscan::ui {

/// Centred on a point; `mark` is the colour of the sign inside. A running state turns with time.
void draw_state(const Ui& ui, float x, float y, State state, float diameter_em, const Colour& mark);

}  // namespace gripscan::ui
