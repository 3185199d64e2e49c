// The turn as a dial that fills towards 360°.
#pragma once

#include "ui/widgets/ui.h"

namespace gripscan::ui {

struct DialState {
    double turned_deg = 0.0;   ///< by accepted steps
    double next_deg = 0.0;     ///< size of the next step; 0: none
    double refused_deg = 0.0;  ///< a refused step lies from turned_deg on; 0: none
    double robot_deg = 0.0;    ///< where the robot stands: the needle
    double whole_deg = 360.0;
};

void draw_closure_dial(const Ui& ui, const Rect& rect, const DialState& dial);

}  // namespace gripscan::ui
