#include "ui/panels/colour_menu.h"

#include <imgui.h>

#include "ui/widgets/draw.h"
#include "ui/widgets/interact.h"

namespace gripscan::ui {
namespace {

constexpr const char* kPopup = "view3d.colour.list";

struct Entry {
    std::string id;
    std::string_view name;
    std::string why_disabled;
    bool chosen = false;
};

bool draw_entry(const Ui& ui, const Rect& rect, const Entry& entry) {
    const auto [event, attention] =
        interact(ui, rect, entry.id, entry.name, entry.why_disabled, {});
    const bool enabled = entry.why_disabled.empty();
    if (entry.chosen) fill(rect, ui.theme.select);
    if (enabled && attention.hovered) fill(rect, ui.theme.hover);
    draw_text(ui, static_cast<float>(rect.x) + ui.scale.em(0.86F),
              static_cast<float>(rect.y) + 0.5F * static_cast<float>(rect.height),
              entry.chosen ? FontRole::kTableStrong : FontRole::kTable,
              enabled ? ui.theme.text : ui.theme.text_third, entry.name);
    if (attention.focused) draw_focus_ring(ui, rect, 0.0F);
    return event.clicked;
}

void draw_list(const Ui& ui, const Rect& field, const Snapshot& snapshot, const SceneParts& parts,
               View3dState& state) {
    const int row = ui.row(1.86F);
    const int pad = ui.em(0.29F);
    const int width = ui.em(11.5F);
    const int rows = static_cast<int>(colourings().size()) + 1;
    ImGui::SetNextWindowPos(
        {static_cast<float>(field.x), static_cast<float>(field.bottom() + pad)});
    ImGui::SetNextWindowSize({static_cast<float>(width), static_cast<float>(rows * row + 2 * pad)});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {0.0F, 0.0F});
    const bool open = ImGui::BeginPopup(kPopup, ImGuiWindowFlags_NoMove);
    ImGui::PopStyleVar();
    if (!open) return;
    const ColourBy shown = shown_colouring(parts, state);
    Rect place{field.x, field.bottom() + 2 * pad, width, row};
    const bool is_pair = parts.kind == SceneKind::kPair;
    if (draw_entry(ui, place,
                   {"view3d.colour.pair", "Two clouds", why_no_pair(snapshot),
                    is_pair && shown == ColourBy::kChunk})) {
        state.wish.pair = true;
        state.colour_by.reset();
        ImGui::CloseCurrentPopup();
    }
    for (const Colouring& colouring : colourings()) {
        place.y += row;
        // The growing cloud is coloured: leaving the two clouds is part of the choice.
        if (draw_entry(ui, place,
                       {"view3d." + std::string(colouring.id), colouring.name,
                        why_no_colouring(colouring.by, parts), shown == colouring.by})) {
            if (colouring.by == ColourBy::kStep) state.wish.pair = false;
            state.colour_by = colouring.by;
            ImGui::CloseCurrentPopup();
        }
    }
    ImGui::EndPopup();
}

}  // namespace

ColourBy shown_colouring(const SceneParts& parts, const View3dState& state) {
    if (state.colour_by && why_no_colouring(*state.colour_by, parts).empty() &&
        !(parts.kind == SceneKind::kPair && *state.colour_by == ColourBy::kStep)) {
        return *state.colour_by;
    }
    return usual_colouring(parts);
}

void draw_colour_menu(const Ui& ui, const Rect& rect, const Snapshot& snapshot,
                      const SceneParts& parts, View3dState& state) {
    const auto [event, attention] =
        interact(ui, rect, "view3d.colour", "Colour", {}, "What colours the points");
    if (attention.hovered) fill(rect, ui.theme.hover, ui.scale.em(0.29F));
    const float y = static_cast<float>(rect.y) + 0.5F * static_cast<float>(rect.height);
    const ColourBy shown = shown_colouring(parts, state);
    const std::string_view name = shown != ColourBy::kChunk ? colouring(shown).name
                                  : parts.kind == SceneKind::kFound
                                      ? std::string_view("Match")
                                      : std::string_view("Two clouds");
    const float chevron = ui.scale.em(1.43F);
    draw_text(ui, static_cast<float>(rect.x) + ui.scale.em(0.43F), y, FontRole::kTableStrong,
              ui.theme.text,
              fitted(ui, FontRole::kTableStrong, name,
                     static_cast<float>(rect.width) - chevron - ui.scale.em(0.43F)));
    draw_icon(ui, static_cast<float>(rect.right()) - 0.5F * chevron, y, Icon::kChevronDown,
              ui.theme.text_second, FontRole::kIconSmall);
    if (attention.focused) draw_focus_ring(ui, rect, ui.scale.em(0.29F));
    if (event.clicked) ImGui::OpenPopup(kPopup);
    draw_list(ui, rect, snapshot, parts, state);
}

}  // namespace gripscan::ui
