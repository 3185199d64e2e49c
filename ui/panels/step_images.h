// The images of the two captures of a step, side by side.
#pragma once

#include "ui/panels/picture_cache.h"
#include "ui/views/snapshot.h"
#include "ui/widgets/ui.h"

namespace gripscan::ui {

/// `pictures` null: only the words are drawn (no OpenGL).
void draw_step_images(const Ui& ui, const Rect& rect, const Snapshot& snapshot,
                      PictureCache* pictures);

}  // namespace gripscan::ui
