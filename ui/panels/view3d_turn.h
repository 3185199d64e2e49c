// The joint axis and the turn about it as lines: so far, next, and of a step what robot and
// registration say.
#pragma once

#include "ui/panels/view3d_lines.h"

namespace gripscan::ui {

/// Nothing while the axis is not known. `room`: what the axis passes through.
void add_turn(const LineInput& input, const Box& room, SceneLines& out);

}  // namespace gripscan::ui
