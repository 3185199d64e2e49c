#include "ui/widgets/verdict_card.h"

#include "ui/widgets/draw.h"
#include "ui/widgets/rich_text.h"

namespace gripscan::ui {
namespace {

constexpr float kSide = 1.14F;
constexpr float kTop = 0.64F;
constexpr float kHead = 1.71F;

int sentence_width(const Ui& ui, int width) {
    return width - ui.em(kSide) - ui.em(0.71F);
}

}  // namespace

int verdict_card_height(const Ui& ui, int width, const VerdictText& verdict) {
    return 2 * ui.em(kTop) + ui.em(kHead) +
           rich_text_height(ui, sentence_width(ui, width), verdict.sentence);
}

int draw_verdict_card(const Ui& ui, int x, int y, int width, const VerdictText& verdict) {
    const int height = verdict_card_height(ui, width, verdict);
    const Colour& colour = colour_of(ui.theme, verdict.state);
    const Colour& tint = tint_of(ui.theme, verdict.state);
    fill({x, y, width, height}, tint, ui.scale.em(0.29F));
    fill({x, y, ui.em(0.29F), height}, colour);
    const int left = x + ui.em(kSide);
    const float head_y = static_cast<float>(y + ui.em(kTop)) + 0.5F * ui.scale.em(kHead);
    draw_state(ui, static_cast<float>(left) + 0.5F * ui.scale.em(1.43F), head_y, verdict.state,
               1.29F, tint);
    const std::string_view shown = verdict.word.empty() ? word(verdict.state) : verdict.word;
    draw_text(ui, static_cast<float>(left + ui.em(1.86F)), head_y, FontRole::kVerdict, colour,
              shown);
    draw_text(ui, static_cast<float>(x + width - ui.em(0.86F)), head_y,
              verdict.basis_is_number ? FontRole::kNumberSmall : FontRole::kSmall,
              ui.theme.text_second, verdict.basis, Align::kRight);
    draw_rich_text(ui, left, y + ui.em(kTop) + ui.em(kHead), sentence_width(ui, width),
                   ui.theme.text, verdict.sentence);
    return height;
}

}  // namespace gripscan::ui
