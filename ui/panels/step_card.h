// The card that decides: where the turn stands, the verdict of the step with its evidence, and what
// can be done about it. Buttons never change their places, but for the one that is next.
#pragma once

#include "ui/layout/window_layout.h"
#include "ui/panels/limit_editor.h"
#include "ui/views/request.h"
#include "ui/views/snapshot.h"
#include "ui/widgets/ui.h"

namespace gripscan::ui {

struct StepCardState {
    bool holding = false;  ///< the button that allows motion was down in the last frame
    double holding_since_s = 0.0;
    LimitEditorState limit;
};

void draw_step_card(const Ui& ui, const Rect& rect, const Snapshot& snapshot, const Detail& detail,
                    StepCardState& local, Requests& out);

}  // namespace gripscan::ui
