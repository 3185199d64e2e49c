#include "ui/panels/keyboard.h"

#include <imgui.h>
#include <imgui_internal.h>

#include "ui/views/actions.h"
#include "ui/widgets/key_press.h"

namespace gripscan::ui {

void take_keys(const Snapshot& snapshot, bool escape_taken, Requests& out) {
    for (const std::string& key : command_keys()) {
        if (escape_taken && key == "Esc") continue;
        // A control of a page that has been left has nothing to say any more.
        const bool belongs_to_control = key == "Space" && ImGui::GetIO().NavVisible &&
                                        ImGui::GetFocusID() != 0 && GImGui->NavIdIsAlive;
        if (belongs_to_control) continue;
        const Requests asked = requests_for_key(key, snapshot);
        out.insert(out.end(), asked.begin(), asked.end());
    }
}

}  // namespace gripscan::ui
