#include "ui/widgets/text_input.h"

#include <imgui.h>
#include <imgui_internal.h>

#include <cmath>

#include "ui/widgets/draw.h"
#include "ui/widgets/tooltip.h"

namespace gripscan::ui {
namespace {

int grow(ImGuiInputTextCallbackData* data) {
    auto& text = *static_cast<std::string*>(data->UserData);
    if (data->EventFlag == ImGuiInputTextFlags_CallbackResize) {
        text.resize(static_cast<std::size_t>(data->BufTextLen));
        data->Buf = text.data();
    }
    return 0;
}

void draw_field(const Ui& ui, const Rect& rect, const TextSpec& spec, bool editing) {
    const Theme& t = ui.theme;
    const Colour& border = spec.wrong ? t.reject : editing ? t.accent : t.edge;
    const float line = editing || spec.wrong ? 2.0F * ui.scale.line() : ui.scale.line();
    const float radius = ui.scale.em(0.29F);
    if (!spec.why_disabled.empty()) {
        dashed_outline(ui, rect, t.line2, 3.0F, 3.0F);
        return;
    }
    fill(rect, t.input, radius);
    outline(rect, border, line, radius);
}

/// The input of Dear ImGui without its frame.
bool edit(const Rect& rect, const TextSpec& spec, const std::string& hidden, std::string& text) {
    constexpr int kAlways = ImGuiInputTextFlags_CallbackResize;
    const ImVec2 size{static_cast<float>(rect.width), static_cast<float>(rect.height)};
    if (spec.lines) {
        return ImGui::InputTextMultiline(hidden.c_str(), text.data(), text.capacity() + 1, size,
                                         kAlways, grow, &text);
    }
    ImGui::SetNextItemWidth(size.x);
    return ImGui::InputText(hidden.c_str(), text.data(), text.capacity() + 1,
                            kAlways | ImGuiInputTextFlags_EnterReturnsTrue, grow, &text);
}

}  // namespace

TextEvent text_input(const Ui& ui, const Rect& rect, const TextSpec& spec, std::string& text) {
    const std::string hidden = "##" + std::string(spec.id);
    const ImGuiID id = ImGui::GetID(hidden.c_str());
    const bool editing = ImGui::GetActiveID() == id;
    ui.log.record({std::string(spec.id), std::string(spec.label), rect, spec.why_disabled.empty(),
                   std::string(spec.why_disabled), editing});
    draw_field(ui, rect, spec, editing);
    const FontRole role = spec.numbers ? FontRole::kNumberTable : FontRole::kTable;
    ImFont* font = ui.fonts[role];
    const int icon = spec.icon == Icon::kNone ? 0 : ui.em(1.71F);
    const float pad = ui.scale.em(0.57F);
    const float middle = spec.lines
                             ? static_cast<float>(rect.y) + ui.scale.em(1.0F)
                             : static_cast<float>(rect.y) + 0.5F * static_cast<float>(rect.height);
    if (icon > 0) {
        draw_icon(ui, static_cast<float>(rect.x) + ui.scale.em(1.0F), middle, spec.icon,
                  ui.theme.text_third, FontRole::kIconSmall);
    }
    if (text.empty()) {
        draw_text(ui, static_cast<float>(rect.x + icon) + (icon > 0 ? ui.scale.em(0.14F) : pad),
                  middle, role, ui.theme.text_third,
                  fitted(ui, role, spec.placeholder, static_cast<float>(rect.width - icon) - pad));
    }
    const float pad_y =
        spec.lines ? pad : std::floor(0.5F * (static_cast<float>(rect.height) - font->FontSize));
    const std::string before = text;
    ImGui::PushFont(font);
    ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {icon > 0 ? ui.scale.em(0.14F) : pad, pad_y});
    ImGui::PushStyleVar(ImGuiStyleVar_FrameBorderSize, 0.0F);
    ImGui::PushStyleColor(ImGuiCol_FrameBg, 0);
    ImGui::PushStyleColor(ImGuiCol_ChildBg, 0);
    ImGui::BeginDisabled(!spec.why_disabled.empty());
    ImGui::SetCursorScreenPos({static_cast<float>(rect.x + icon), static_cast<float>(rect.y)});
    if (spec.take_keyboard) ImGui::SetKeyboardFocusHere();
    if (spec.to_end && ImGui::GetActiveID() == id) ImGui::ClearActiveID();  // takes the new text
    TextEvent event;
    event.entered =
        edit({rect.x + icon, rect.y, rect.width - icon, rect.height}, spec, hidden, text) &&
        !spec.lines;
    ImGui::EndDisabled();
    if (!spec.why_disabled.empty()) {
        tooltip(ui, {std::string(spec.label) + " is not possible", {}, spec.why_disabled});
    }
    ImGui::PopStyleColor(2);
    ImGui::PopStyleVar(2);
    ImGui::PopFont();
    event.changed = text != before;
    return event;
}

}  // namespace gripscan::ui
