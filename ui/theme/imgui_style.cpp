#include "ui/theme/imgui_style.h"

namespace gripscan::ui {
namespace {

ImVec4 vec(const Colour& c) {
    return ImGui::ColorConvertU32ToFloat4(c.packed());
}

void set_colours(ImGuiStyle& style, const Theme& theme) {
    const auto set = [&](ImGuiCol which, const Colour& colour) {
        style.Colors[which] = vec(colour);
    };
    set(ImGuiCol_Text, theme.text);
    set(ImGuiCol_TextDisabled, theme.text_third);
    set(ImGuiCol_WindowBg, theme.panel);
    set(ImGuiCol_ChildBg, theme.panel.with_alpha(0.0));
    set(ImGuiCol_PopupBg, theme.panel);
    set(ImGuiCol_Border, theme.line2);
    set(ImGuiCol_FrameBg, theme.input);
    set(ImGuiCol_FrameBgHovered, theme.input);
    set(ImGuiCol_FrameBgActive, theme.input);
    set(ImGuiCol_ScrollbarBg, theme.panel.with_alpha(0.0));
    set(ImGuiCol_ScrollbarGrab, theme.line2);
    set(ImGuiCol_ScrollbarGrabHovered, theme.edge);
    set(ImGuiCol_ScrollbarGrabActive, theme.edge);
    set(ImGuiCol_CheckMark, theme.accent);
    set(ImGuiCol_SliderGrab, theme.text);
    set(ImGuiCol_SliderGrabActive, theme.text);
    set(ImGuiCol_Button, theme.raised);
    set(ImGuiCol_ButtonHovered, theme.hover);
    set(ImGuiCol_ButtonActive, theme.bg0);
    set(ImGuiCol_Header, theme.select);
    set(ImGuiCol_HeaderHovered, theme.hover);
    set(ImGuiCol_HeaderActive, theme.select);
    set(ImGuiCol_Separator, theme.line);
    set(ImGuiCol_TextSelectedBg, theme.accent.with_alpha(0.35));
    set(ImGuiCol_NavHighlight, theme.accent_text);
    set(ImGuiCol_ModalWindowDimBg, theme.bg0.with_alpha(0.45));
    set(ImGuiCol_DragDropTarget, theme.accent);
}

void set_sizes(ImGuiStyle& style, Scale scale) {
    style.WindowPadding = {0, 0};
    style.WindowRounding = 0.0F;
    style.WindowBorderSize = 0.0F;
    style.WindowMinSize = {1, 1};
    style.ChildRounding = 0.0F;
    style.ChildBorderSize = 0.0F;
    style.PopupRounding = scale.em(0.36F);
    style.PopupBorderSize = scale.line();
    style.FramePadding = {scale.em(0.57F), scale.em(0.29F)};
    style.FrameRounding = scale.em(0.29F);
    style.FrameBorderSize = scale.line();
    style.ItemSpacing = {scale.em(0.57F), scale.em(0.57F)};
    style.ItemInnerSpacing = {scale.em(0.29F), scale.em(0.29F)};
    style.CellPadding = {scale.em(0.57F), 0.0F};
    style.ScrollbarSize = scale.em(0.57F);
    style.ScrollbarRounding = scale.em(0.29F);
    style.GrabMinSize = scale.em(0.71F);
    style.GrabRounding = scale.em(0.14F);
}

}  // namespace

ImGuiStyle imgui_style(const Theme& theme, Scale scale) {
    ImGuiStyle style;
    set_colours(style, theme);
    set_sizes(style, scale);
    return style;
}

}  // namespace gripscan::ui
