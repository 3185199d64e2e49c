// The theme as the style of Dear ImGui, for what the own widgets do not draw themselves: windows,
// scroll bars, text inputs, tooltips.
#pragma once

#include <imgui.h>

#include "ui/layout/scale.h"
#include "ui/theme/theme.h"

namespace gripscan::ui {

/// A fresh style of that theme at that scale. Applied between frames.
[[nodiscard]] ImGuiStyle imgui_style(const Theme& theme, Scale scale);

}  // namespace gripscan::ui
