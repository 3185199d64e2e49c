// The card at the lower left of the 3D view: what the colours mean, with a range that can be typed;
// of the two clouds of a step which is which, and how they stand.
#pragma once

#include "ui/panels/view3d_state.h"
#include "ui/widgets/ui.h"

namespace gripscan::ui {

/// What is shown.
struct LegendInput {
    const SceneParts& parts;
    ColourBy by = ColourBy::kStep;
    LegendRange range;   ///< in the unit of the colouring
    bool ghost = false;  ///< the outline of the next view is drawn
};
void draw_view3d_legend(const Ui& ui, const Rect& rect, const LegendInput& input,
                        View3dState& state);

/// What was measured, below the tools.
void draw_measure_card(const Ui& ui, const Rect& rect, const Snapshot& snapshot,
                       const Measuring& measuring);

}  // namespace gripscan::ui
