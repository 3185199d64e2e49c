// The tools over the 3D view: colouring and point size at the left, points and views at the right.
#pragma once

#include "ui/panels/view3d_state.h"
#include "ui/views/request.h"
#include "ui/views/view_keys.h"
#include "ui/widgets/ui.h"

namespace gripscan::ui {

/// Why side by side is not possible; empty: it is.
[[nodiscard]] std::string why_no_side_by_side(const SceneParts& parts);

/// What was pressed beside what changed in the state.
[[nodiscard]] std::optional<ViewCommand> draw_view3d_tools(const Ui& ui, const Rect& rect,
                                                           const Snapshot& snapshot,
                                                           const SceneParts& parts,
                                                           View3dState& state, Requests& out);

}  // namespace gripscan::ui
