#include "ui/widgets/dialog_frame.h"

#include <imgui.h>

#include <string>

#include "ui/widgets/draw.h"
#include "ui/widgets/interact.h"

namespace gripscan::ui {
namespace {

constexpr float kHeader = 3.29F;
constexpr float kFooter = 4.29F;
constexpr float kSide = 1.29F;
constexpr float kRing = 0.29F;

Rect centred(const Rect& room, int width, int height) {
    return {room.x + (room.width - width) / 2, room.y + (room.height - height) / 2, width, height};
}

void begin_window(const Rect& at, std::string_view id) {
    ImGui::SetNextWindowPos({static_cast<float>(at.x), static_cast<float>(at.y)});
    ImGui::SetNextWindowSize({static_cast<float>(at.width), static_cast<float>(at.height)});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {0.0F, 0.0F});
    ImGui::Begin(("###" + std::string(id)).c_str(), nullptr,
                 ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove |
                     ImGuiWindowFlags_NoBackground | ImGuiWindowFlags_NoSavedSettings |
                     ImGuiWindowFlags_NoScrollWithMouse);
    ImGui::PopStyleVar();
}

void draw_card(const Ui& ui, const Rect& card) {
    const Theme& t = ui.theme;
    const float radius = ui.scale.em(0.50F);
    const int ring = ui.em(kRing);
    fill(card.shrunk(-ring), Colour{0, 0, 0}.with_alpha(t.dark ? 0.45 : 0.20),
         radius + static_cast<float>(ring));
    fill(card, t.panel, radius);
    outline(card, t.line2, ui.scale.line(), radius);
}

}  // namespace

DialogFrame::DialogFrame(const Ui& ui, const Rect& room, const DialogSpec& spec) : ui_(ui) {
    const int ring = ui.em(kRing);
    const int header = ui.em(kHeader);
    const int footer = ui.row(kFooter);
    const int side = ui.em(kSide);
    const Rect most = room.shrunk(2 * ring);
    const Rect card =
        centred(room, std::min(ui.em(spec.width_em), most.width),
                std::min(header + spec.body_height + 2 * ui.em(0.86F) + footer, most.height));
    begin_window(spec.modal ? room : card.shrunk(-ring), spec.id);
    appeared_ = ImGui::IsWindowAppearing();
    const bool has_focus = ImGui::IsWindowFocused(ImGuiFocusedFlags_ChildWindows);
    closed_ = escape_pressed() && (spec.modal || has_focus);
    confirmed_ = enter_pressed() && keyboard_is_free() && (spec.modal || has_focus) && !appeared_;
    ui.log.record({std::string(spec.id), std::string(spec.title), card, true, {}});
    draw_card(ui, card);

    const float middle = static_cast<float>(card.y) + 0.5F * static_cast<float>(header);
    draw_text(ui, static_cast<float>(card.x + side), middle, FontRole::kVerdict, ui.theme.text,
              spec.title);
    const std::string close_id = std::string(spec.id) + ".close";
    const int cross = ui.em(2.14F);
    closed_ |=
        icon_button(
            ui, {card.right() - cross - ui.em(0.57F), card.y + (header - cross) / 2, cross, cross},
            {.id = close_id, .label = {}, .icon = Icon::kClose, .tooltip = "Close"})
            .clicked;
    const int line = static_cast<int>(ui.scale.line());
    fill({card.x, card.y + header - line, card.width, line}, ui.theme.line);
    footer_ = {card.x + side, card.bottom() - footer, card.width - 2 * side, footer};
    const Rect region{card.x + side, card.y + header, card.width - 2 * side + ui.em(0.86F),
                      footer_.y - card.y - header};
    scroll_.emplace(ui, region, std::string(spec.id) + ".body");
    body_ = {region.x, scroll_->rect().y + ui.em(0.86F), card.width - 2 * side, spec.body_height};
}

void DialogFrame::end_body(int content_end_y) {
    scroll_->end(content_end_y + ui_.em(0.57F));
    scroll_.reset();
}

void DialogFrame::end() {
    ImGui::End();
}

std::optional<std::size_t> dialog_buttons(const Ui& ui, const DialogFrame& frame,
                                          std::span<const ButtonSpec> buttons) {
    std::optional<std::size_t> pressed;
    const int height = ui.row(2.57F);
    const Rect& footer = frame.footer();
    int x = footer.right();
    for (std::size_t k = buttons.size(); k-- > 0;) {
        const ButtonSpec& spec = buttons[k];
        if (spec.label.empty()) continue;
        const bool last = k + 1 == buttons.size();
        const FontRole role = last ? FontRole::kNextAction : FontRole::kButton;
        const int words = static_cast<int>(text_width(ui, role, spec.label));
        const int extra =
            ui.em(2.6F) + (spec.icon == Icon::kNone ? 0 : ui.em(1.86F)) +
            (spec.key.empty() ? 0
                              : ui.em(1.4F) + static_cast<int>(text_width(
                                                  ui, FontRole::kNumberCaption, spec.key)));
        const Rect at{x - words - extra, footer.y + (footer.height - height) / 2, words + extra,
                      height};
        if (button(ui, at, spec)) pressed = k;
        x = at.x - ui.em(0.57F);
    }
    if (!pressed && frame.confirmed() && !buttons.empty() && buttons.back().why_disabled.empty() &&
        !buttons.back().label.empty()) {
        pressed = buttons.size() - 1;
    }
    return pressed;
}

}  // namespace gripscan::ui
