// A button of an action of the table: label, key, tooltip and reason come from there.
#pragma once

#include "ui/views/actions.h"
#include "ui/widgets/button.h"

namespace gripscan::ui {

struct ActionLook {
    ButtonLook look = ButtonLook::kNormal;
    bool icon = true;
    std::string_view label = {};  ///< empty: the action's own
};

[[nodiscard]] Icon icon_of(const Action& action);

/// Emits the action's request when pressed.
void action_button(const Ui& ui, const Rect& rect, const Action& action, const Snapshot& snapshot,
                   const ActionLook& look, Requests& out);
/// The icon alone, in bars.
void action_icon(const Ui& ui, const Rect& rect, const Action& action, const Snapshot& snapshot,
                 Requests& out);

}  // namespace gripscan::ui
