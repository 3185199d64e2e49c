// A number of the plan as it is edited: what it is, an input, its default or the way back to it.
#pragma once

#include <string>

#include "ui/layout/rect.h"
#include "ui/views/cell_view.h"
#include "ui/widgets/ui.h"

namespace gripscan::ui {

/// `field`: its place in plan_fields(). `why_fixed` empty: it can be changed, by request::SetPlan.
void draw_plan_field(const Ui& ui, const Rect& row, const TurnPlan& plan, std::size_t field,
                     const std::string& why_fixed, Requests& out);

}  // namespace gripscan::ui
