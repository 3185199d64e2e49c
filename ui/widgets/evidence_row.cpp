#include "ui/widgets/evidence_row.h"

#include <algorithm>
#include <cmath>

#include "ui/widgets/draw.h"
#include "ui/widgets/interact.h"
#include "ui/widgets/tooltip.h"

namespace gripscan::ui {
namespace {

constexpr double kLimitAt = 2.0 / 3.0;

void draw_bar(const Ui& ui, const Rect& rect, const Evidence& evidence, const Colour& colour) {
    const float radius = 0.5F * static_cast<float>(rect.height);
    fill(rect, ui.theme.hover, radius);
    Rect part = rect;
    part.width = static_cast<int>(bar_part(evidence.value, evidence.limit) * rect.width);
    fill(part, colour, std::min(radius, 0.5F * static_cast<float>(part.width)));
    const int tick = rect.x + static_cast<int>(kLimitAt * rect.width);
    fill({tick, rect.y - ui.px(4), static_cast<int>(ui.scale.line()), rect.height + ui.px(8)},
         ui.theme.text_second);
}

}  // namespace

double bar_part(double value, double limit) {
    if (!std::isfinite(value) || !(limit > 0.0)) return 0.0;
    return std::min(1.0, std::abs(value) / limit * kLimitAt);
}

bool evidence_row(const Ui& ui, const Rect& rect, const Evidence& evidence) {
    const std::string shown = shown_number(evidence.value, evidence.decimals,
                                           evidence.with_sign ? Sign::kAlways : Sign::kMinusOnly);
    const auto [event, attention] = interact(ui, rect, evidence.id, evidence.label, {}, {});
    tooltip(ui, {evidence.label, shown, evidence.meaning});
    if (attention.hovered) fill(rect, ui.theme.raised, ui.scale.em(0.21F));
    const bool limited = std::isfinite(evidence.limit);
    const bool fine = !limited || evidence.state == State::kAccept;
    const Colour& bar = evidence.past ? ui.theme.line2
                        : fine        ? ui.theme.text_second
                                      : colour_of(ui.theme, evidence.state);
    const Colour& number = evidence.past ? ui.theme.text_third
                           : fine        ? ui.theme.text
                                         : colour_of(ui.theme, evidence.state);

    const float y = static_cast<float>(rect.y) + 0.5F * static_cast<float>(rect.height);
    const int right = rect.right();
    const int shape = right - ui.em(0.57F);
    const int limit = right - ui.em(1.57F);
    const float bar_em = rect.width < ui.em(24.0F) ? 3.29F : 5.57F;
    const int bar_x = right - ui.em(6.14F + bar_em);
    const int unit = bar_x - ui.em(1.86F);
    draw_text(ui, static_cast<float>(rect.x), y, FontRole::kTable,
              evidence.past ? ui.theme.text_third : ui.theme.text_second,
              fitted(ui, FontRole::kTable, evidence.label,
                     static_cast<float>(unit - rect.x) -
                         text_width(ui, FontRole::kNumberTable, shown) - ui.scale.em(0.71F)));
    draw_text(ui, static_cast<float>(unit), y, FontRole::kNumberTable, number, shown,
              Align::kRight);
    draw_text(ui, static_cast<float>(unit + ui.em(0.21F)), y, FontRole::kNumberCaption,
              ui.theme.text_third, evidence.unit);
    if (!limited) return event.clicked;
    draw_bar(ui, {bar_x, static_cast<int>(y) - ui.px(2), ui.em(bar_em), ui.px(4)}, evidence, bar);
    const std::string limit_text = (evidence.kind == LimitKind::kAtMost ? "≤ " : "≥ ") +
                                   shown_number(evidence.limit, evidence.limit_decimals);
    draw_text(ui, static_cast<float>(limit), y, FontRole::kNumberTable, ui.theme.text_third,
              limit_text, Align::kRight);
    if (evidence.past) return event.clicked;
    draw_state(ui, static_cast<float>(shape), y, evidence.state, 0.93F, ui.theme.panel);
    return event.clicked;
}

}  // namespace gripscan::ui
