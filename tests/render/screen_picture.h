// A screen of the window as a picture, drawn without a window.
#pragma once

#include <functional>

#include "tests/support/golden_image.h"
#include "ui/layout/scale.h"
#include "ui/theme/theme.h"
#include "ui/widgets/ui.h"

namespace gripscan::test {

/// Needs a current OpenGL context. `draw` is called for three frames, of which the last is taken.
[[nodiscard]] Picture screen_picture(int width_px, int height_px, ui::Scale scale,
                                     ui::ThemeChoice theme,
                                     const std::function<void(const ui::Ui&)>& draw);

}  // namespace gripscan::test
