// Every component of the window in its states, on one page: the reference of the widget library.
#pragma once

#include "ui/widgets/ui.h"

namespace gripscan::test {

inline constexpr int kGalleryWidth = 1600;  ///< px at 100 %
inline constexpr int kGalleryHeight = 1000;

void draw_widget_gallery(const ui::Ui& ui);

}  // namespace gripscan::test
