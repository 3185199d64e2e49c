#include "ui/widgets/splitter.h"

#include <imgui.h>

#include "ui/widgets/draw.h"
#include "ui/widgets/interact.h"

namespace gripscan::ui {

SplitterEvent splitter(const Ui& ui, const Rect& rect, std::string_view id, SplitterWay way) {
    fill(rect, ui.theme.bg0);
    if (rect.empty()) return {};
    const bool sideways = way == SplitterWay::kLeftRight;
    Rect hit = rect;
    const int more = ui.px(2);
    if (sideways) {
        hit.x -= more;
        hit.width += 2 * more;
    } else {
        hit.y -= more;
        hit.height += 2 * more;
    }
    const auto [event, attention] = interact(ui, hit, id, "edge", {}, {});
    if (attention.hovered || attention.held) {
        ImGui::SetMouseCursor(sideways ? ImGuiMouseCursor_ResizeEW : ImGuiMouseCursor_ResizeNS);
        fill(rect, attention.held ? ui.theme.accent : ui.theme.line2);
    }
    SplitterEvent result;
    result.reset = attention.hovered && ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left);
    if (attention.held && !result.reset) {
        const ImVec2 delta = ImGui::GetIO().MouseDelta;
        result.moved_px = static_cast<int>(sideways ? delta.x : delta.y);
    }
    return result;
}

}  // namespace gripscan::ui
