#include "ui/widgets/scroll_area.h"

#include <imgui.h>

#include <string>

namespace gripscan::ui {

ScrollArea::ScrollArea(const Ui&, const Rect& region, std::string_view id) : rect_(region) {
    ImGui::SetCursorScreenPos({static_cast<float>(region.x), static_cast<float>(region.y)});
    ImGui::BeginChild(std::string(id).c_str(),
                      {static_cast<float>(std::max(1, region.width)),
                       static_cast<float>(std::max(1, region.height))},
                      false, ImGuiWindowFlags_NavFlattened);
    rect_.y -= static_cast<int>(ImGui::GetScrollY());
}

void ScrollArea::end(int content_end_y) {
    ImGui::SetCursorScreenPos({static_cast<float>(rect_.x), static_cast<float>(content_end_y)});
    ImGui::Dummy({1.0F, 0.0F});
    ImGui::EndChild();
}

}  // namespace gripscan::ui
