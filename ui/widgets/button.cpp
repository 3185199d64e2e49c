#include "ui/widgets/button.h"

#include <fmt/format.h>
#include <imgui.h>

#include "ui/widgets/draw.h"
#include "ui/widgets/interact.h"

namespace gripscan::ui {
namespace {

struct Paint {
    Colour fill;
    Colour border;
    Colour text;
    Colour icon;
    float border_width = 1.0F;
};

Paint normal_paint(const Ui& ui, const Attention& attention) {
    const Theme& t = ui.theme;
    if (attention.held) return {t.bg0, t.text_third, t.text, t.text_second, ui.scale.line()};
    if (attention.hovered) return {t.hover, t.line2, t.text, t.text_second, ui.scale.line()};
    return {t.raised, t.line2, t.text, t.text_second, ui.scale.line()};
}

Paint paint_of(const Ui& ui, const ButtonSpec& spec, const Attention& attention) {
    const Theme& t = ui.theme;
    Paint paint = normal_paint(ui, attention);
    switch (spec.look) {
        case ButtonLook::kNormal:
            if (spec.chosen) paint.fill = t.hover;
            break;
        case ButtonLook::kStop:
            paint.text = paint.icon = t.reject;
            break;
        case ButtonLook::kSecond:
            paint = {t.accent_bg, t.accent, t.text, t.accent_text, 2.0F * ui.scale.line()};
            break;
        case ButtonLook::kNext:
            paint.fill = attention.held      ? mixed(t.accent, {0, 0, 0}, 0.08)
                         : attention.hovered ? mixed(t.accent, {255, 255, 255}, 0.08)
                                             : t.accent;
            paint.border_width = 0.0F;
            paint.text = paint.icon = t.accent_on;
            break;
        case ButtonLook::kHold:
            paint.fill = attention.hovered ? mixed(t.live, {255, 255, 255}, 0.08) : t.live;
            paint.border_width = 0.0F;
            paint.text = paint.icon = t.live_on;
            break;
    }
    return paint;
}

/// Icon, word and key, centred as one.
void draw_content(const Ui& ui, const Rect& rect, const ButtonSpec& spec, const Paint& paint) {
    const bool big = spec.look == ButtonLook::kNext || spec.look == ButtonLook::kHold;
    const FontRole role = big ? FontRole::kNextAction : FontRole::kButton;
    const float icon = spec.icon == Icon::kNone ? 0.0F : ui.scale.em(big ? 1.29F : 1.14F);
    const float gap = ui.scale.em(0.43F);
    const float key_gap = ui.scale.em(0.64F);
    const float key = spec.key.empty() ? 0.0F
                                       : text_width(ui, FontRole::kNumberCaption, spec.key) +
                                             2.0F * ui.scale.em(0.29F);
    const float room = static_cast<float>(rect.width) - 2.0F * ui.scale.em(0.36F) -
                       (icon > 0 ? icon + gap : 0.0F) - (key > 0 ? key + key_gap : 0.0F);
    const std::string label = fitted(ui, role, spec.label, room);
    const float words = text_width(ui, role, label);
    const float total = words + (icon > 0 ? icon + gap : 0) + (key > 0 ? key + key_gap : 0);
    float x = static_cast<float>(rect.x) + 0.5F * (static_cast<float>(rect.width) - total);
    const float y = static_cast<float>(rect.y) + 0.5F * static_cast<float>(rect.height);
    if (icon > 0.0F) {
        draw_icon(ui, x + 0.5F * icon, y, spec.icon, paint.icon,
                  big ? FontRole::kIcon : FontRole::kIconSmall);
        x += icon + gap;
    }
    x = draw_text(ui, x, y, role, paint.text, label);
    if (key > 0.0F) {
        const Colour muted = big ? paint.text : ui.theme.text_third;
        draw_key_cap(ui, x + key_gap + key, y, spec.key, muted);
    }
}

}  // namespace

float draw_key_cap(const Ui& ui, float right, float y, std::string_view key, const Colour& colour) {
    const float width = text_width(ui, FontRole::kNumberCaption, key) + 2.0F * ui.scale.em(0.29F);
    const float height = ui.scale.em(1.21F);
    const Rect cap{static_cast<int>(right - width), static_cast<int>(y - 0.5F * height),
                   static_cast<int>(width), static_cast<int>(height)};
    outline(cap, mixed(ui.theme.panel, colour, 0.6), ui.scale.line(), ui.scale.em(0.21F));
    draw_text(ui, static_cast<float>(cap.x) + 0.5F * static_cast<float>(cap.width), y,
              FontRole::kNumberCaption, colour, key, Align::kCentre);
    return right - width;
}

void draw_button(const Ui& ui, const Rect& rect, const ButtonSpec& spec,
                 const Attention& attention) {
    const float radius = ui.scale.em(0.36F);
    if (!spec.why_disabled.empty()) {
        dashed_outline(ui, rect, ui.theme.line2, 3.0F, 3.0F);
        const Colour grey = ui.theme.text_third;
        draw_content(ui, rect, spec, {{}, {}, grey, grey});
        return;
    }
    const Paint paint = paint_of(ui, spec, attention);
    fill(rect, paint.fill, radius);
    if (spec.look == ButtonLook::kHold && spec.held_part > 0.0F) {
        Rect part = rect;
        part.width = static_cast<int>(spec.held_part * static_cast<float>(rect.width));
        fill(part, mixed(ui.theme.live, {0, 0, 0}, 0.3), radius);
    }
    if (paint.border_width > 0.0F) outline(rect, paint.border, paint.border_width, radius);
    draw_content(ui, rect, spec, paint);
    if (attention.focused) draw_focus_ring(ui, rect, radius);
}

ButtonEvent button(const Ui& ui, const Rect& rect, const ButtonSpec& spec) {
    const auto [event, attention] =
        interact(ui, rect, spec.id, spec.label, spec.why_disabled, spec.tooltip);
    draw_button(ui, rect, spec, attention);
    return event;
}

ButtonEvent icon_button(const Ui& ui, const Rect& rect, const ButtonSpec& spec) {
    const auto [event, attention] =
        interact(ui, rect, spec.id, spec.tooltip, spec.why_disabled, spec.tooltip);
    const float radius = ui.scale.em(0.29F);
    const bool enabled = spec.why_disabled.empty();
    if (enabled && (spec.chosen || attention.hovered)) fill(rect, ui.theme.hover, radius);
    const Colour grey = mixed(ui.theme.line2, ui.theme.text_third, 0.6);
    const Colour& colour = !enabled ? grey : spec.chosen ? ui.theme.text : ui.theme.text_second;
    draw_icon(ui, static_cast<float>(rect.x) + 0.5F * static_cast<float>(rect.width),
              static_cast<float>(rect.y) + 0.5F * static_cast<float>(rect.height), spec.icon,
              colour);
    if (attention.focused) draw_focus_ring(ui, rect, radius);
    return event;
}

}  // namespace gripscan::ui
