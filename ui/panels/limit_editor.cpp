#include "ui/panels/limit_editor.h"

#include <imgui.h>

#include "ui/panels/panel_parts.h"
#include "ui/panels/plan_field.h"

namespace gripscan::ui {
namespace {

constexpr const char* kName = "limit.editor";
constexpr float kRow_em = 2.14F;

}  // namespace

void open_limit_editor(LimitEditorState& local, const Snapshot& snapshot, std::string_view evidence,
                       const Rect& row) {
    if (!why_limit_is_fixed(snapshot, evidence).empty()) return;
    local.evidence = evidence;
    local.row = row;
    ImGui::OpenPopup(kName);
}

void draw_limit_editor(const Ui& ui, const Snapshot& snapshot, const LimitEditorState& local,
                       Requests& out) {
    const auto fields = limit_fields(local.evidence);
    if (snapshot.procedure == nullptr || fields.empty()) return;
    const int pad = ui.em(0.86F);
    const int width = local.row.width + 2 * pad;
    const int height =
        ui.em(1.43F) + ui.em(kRow_em) * static_cast<int>(fields.size()) + 2 * ui.em(0.57F);
    ImGui::SetNextWindowPos({static_cast<float>(local.row.x - pad),
                             static_cast<float>(local.row.bottom() + ui.em(0.29F))});
    ImGui::SetNextWindowSize({static_cast<float>(width), static_cast<float>(height)});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {0.0F, 0.0F});
    const bool open = ImGui::BeginPopup(kName);
    ImGui::PopStyleVar();
    if (!open) return;
    const ImVec2 corner = ImGui::GetWindowPos();
    Rect row{static_cast<int>(corner.x) + pad, static_cast<int>(corner.y) + ui.em(0.57F),
             local.row.width, ui.em(1.43F)};
    draw_text(ui, static_cast<float>(row.x), middle_of(row), FontRole::kCaption,
              ui.theme.text_third, "Limit for every step of the turn");
    row = {row.x, row.bottom(), row.width, ui.em(kRow_em)};
    for (const std::size_t field : fields) {
        draw_plan_field(ui, row, snapshot.procedure->plan, field, {}, out);
        row.y = row.bottom();
    }
    ImGui::EndPopup();
}

}  // namespace gripscan::ui
