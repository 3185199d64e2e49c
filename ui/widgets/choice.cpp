#include "ui/widgets/choice.h"

#include "ui/widgets/draw.h"
#include "ui/widgets/interact.h"

namespace gripscan::ui {
namespace {

float middle_y(const Rect& rect) {
    return static_cast<float>(rect.y) + 0.5F * static_cast<float>(rect.height);
}

float tab_width(const Ui& ui, const Option& option) {
    float width = text_width(ui, FontRole::kPanelTitle, option.label) + 2.0F * ui.scale.em(0.86F);
    if (option.icon != Icon::kNone) width += ui.scale.em(1.57F);
    if (!option.count.empty()) {
        width += text_width(ui, FontRole::kNumberSmall, option.count) + ui.scale.em(0.57F);
    }
    return width;
}

void draw_tab(const Ui& ui, const Rect& tab, const Option& option, bool is_chosen, bool hovered) {
    const Colour& colour = !option.why_disabled.empty() ? ui.theme.text_third
                           : is_chosen || hovered       ? ui.theme.text
                                                        : ui.theme.text_second;
    float x = static_cast<float>(tab.x) + ui.scale.em(0.86F);
    if (option.icon != Icon::kNone) {
        draw_icon(ui, x + 0.5F * ui.scale.em(1.14F), middle_y(tab), option.icon, colour,
                  FontRole::kIconSmall);
        x += ui.scale.em(1.57F);
    }
    x = draw_text(ui, x, middle_y(tab), FontRole::kPanelTitle, colour, option.label);
    draw_text(ui, x + ui.scale.em(0.57F), middle_y(tab), FontRole::kNumberSmall,
              ui.theme.text_third, option.count);
    const int bar = ui.px(2);
    if (is_chosen) fill({tab.x, tab.bottom() - bar, tab.width, bar}, ui.theme.text);
}

}  // namespace

std::optional<std::size_t> segments(const Ui& ui, const Rect& rect, std::span<const Option> options,
                                    std::size_t chosen) {
    std::optional<std::size_t> clicked;
    const float radius = ui.scale.em(0.29F);
    const int line = static_cast<int>(ui.scale.line());
    fill(rect, ui.theme.dark ? ui.theme.bg0 : ui.theme.raised, radius);
    const int count = static_cast<int>(options.size());
    for (int i = 0; i < count; ++i) {
        const auto index = static_cast<std::size_t>(i);
        const Option& option = options[index];
        const int left = rect.x + rect.width * i / count;
        const Rect segment{left, rect.y, rect.x + rect.width * (i + 1) / count - left, rect.height};
        const auto [event, attention] =
            interact(ui, segment, option.id, option.label, option.why_disabled, {});
        if (event.clicked) clicked = index;
        const bool on = index == chosen;
        if (on) {
            fill(segment.shrunk(line), ui.theme.dark ? ui.theme.hover : ui.theme.input,
                 radius - ui.scale.line());
        }
        if (i > 0) fill({left, rect.y, line, rect.height}, ui.theme.line2);
        const Colour& colour = !option.why_disabled.empty() ? ui.theme.text_third
                               : on || attention.hovered    ? ui.theme.text
                                                            : ui.theme.text_second;
        draw_text(ui, static_cast<float>(left) + 0.5F * static_cast<float>(segment.width),
                  middle_y(rect), on ? FontRole::kTableStrong : FontRole::kTable, colour,
                  option.label, Align::kCentre);
        if (attention.focused) draw_focus_ring(ui, segment, radius);
    }
    outline(rect, ui.theme.line2, ui.scale.line(), radius);
    return clicked;
}

std::optional<std::size_t> tabs(const Ui& ui, const Rect& rect, std::span<const Option> options,
                                std::size_t chosen) {
    std::optional<std::size_t> clicked;
    int x = rect.x;
    for (std::size_t i = 0; i < options.size(); ++i) {
        const Rect tab{x, rect.y, static_cast<int>(tab_width(ui, options[i])), rect.height};
        const auto [event, attention] =
            interact(ui, tab, options[i].id, options[i].label, options[i].why_disabled, {});
        if (event.clicked) clicked = i;
        draw_tab(ui, tab, options[i], i == chosen, attention.hovered);
        if (attention.focused) draw_focus_ring(ui, tab, 0.0F);
        x = tab.right();
    }
    return clicked;
}

bool check_box(const Ui& ui, const Rect& rect, std::string_view id, std::string_view label, bool on,
               std::string_view why_disabled) {
    const auto [event, attention] = interact(ui, rect, id, label, why_disabled, {});
    const int side = ui.em(1.14F);
    const Rect box{rect.x, static_cast<int>(middle_y(rect)) - side / 2, side, side};
    const float radius = ui.scale.em(0.21F);
    const bool enabled = why_disabled.empty();
    if (on) {
        fill(box, enabled ? ui.theme.accent : ui.theme.line2, radius);
        draw_icon(ui, static_cast<float>(box.x) + 0.5F * static_cast<float>(side), middle_y(rect),
                  Icon::kCheck, ui.theme.accent_on, FontRole::kIconSmall);
    } else {
        outline(box, enabled ? ui.theme.edge : ui.theme.line2, ui.scale.line(), radius);
    }
    draw_text(ui, static_cast<float>(box.right()) + ui.scale.em(0.5F), middle_y(rect),
              FontRole::kTable, enabled ? ui.theme.text : ui.theme.text_third, label);
    if (attention.focused) draw_focus_ring(ui, box, radius);
    return event.clicked;
}

}  // namespace gripscan::ui
