// Colours of the theme as text on the plates that labels of camera images stand on: the plates are
// dark in both themes, the light theme's colours are too.
#pragma once

#include "ui/theme/theme.h"

namespace gripscan::ui {

/// The colour itself where it can be read (4.5 : 1 over the brightest image), else the same hue,
/// brighter.
[[nodiscard]] Colour on_plate(const Theme& theme, const Colour& colour);

}  // namespace gripscan::ui
