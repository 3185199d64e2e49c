// What every widget and panel gets: how things look, and where they are noted.
#pragma once

#include "ui/fonts/font_set.h"
#include "ui/layout/scale.h"
#include "ui/theme/theme.h"
#include "ui/widgets/widget_log.h"

namespace gripscan::ui {

/// Valid for one frame; nothing is kept in it.
struct Ui {
    const Theme& theme;
    const FontSet& fonts;
    Scale scale;
    WidgetLog& log;
    double time_s = 0.0;         ///< since the window opened; moves what turns
    bool large_buttons = false;  ///< for gloves: button and row heights × 1.35

    [[nodiscard]] int em(float length_em) const { return static_cast<int>(scale.em(length_em)); }
    [[nodiscard]] int px(float length_px) const { return static_cast<int>(scale.px(length_px)); }
    /// Height of a button or row.
    [[nodiscard]] int row(float length_em) const {
        return em(large_buttons ? 1.35F * length_em : length_em);
    }
};

}  // namespace gripscan::ui
