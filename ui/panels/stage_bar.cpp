#include "ui/panels/stage_bar.h"

#include "ui/views/stages.h"
#include "ui/widgets/draw.h"
#include "ui/widgets/interact.h"
#include "ui/widgets/state_shape.h"
#include "ui/widgets/tooltip.h"

namespace gripscan::ui {
namespace {

struct Place {
    Rect rect;
    bool two_lines;
    bool with_criterion;
};

const Colour& bar_colour(const Ui& ui, State state) {
    return state == State::kCheck || state == State::kReject ? colour_of(ui.theme, state)
                                                             : ui.theme.accent;
}

void draw_background(const Ui& ui, const Rect& rect, const StageText& stage, bool hovered) {
    if (stage.current) {
        const bool refused = stage.state == State::kReject;
        fill(rect, refused ? ui.theme.reject_bg : ui.theme.accent_bg);
        const int bar = ui.px(3);
        fill({rect.x, rect.bottom() - bar, rect.width, bar}, bar_colour(ui, stage.state));
    } else if (hovered) {
        fill(rect, ui.theme.raised);
    }
}

void draw_words(const Ui& ui, const Place& at, const StageText& stage) {
    const Rect& rect = at.rect;
    const float middle = static_cast<float>(rect.y) + 0.5F * static_cast<float>(rect.height);
    const float shape = static_cast<float>(rect.x) + ui.scale.em(at.two_lines ? 1.5F : 1.07F);
    const Colour& ground =
        stage.current ? (stage.state == State::kReject ? ui.theme.reject_bg : ui.theme.accent_bg)
                      : ui.theme.panel;
    draw_state(ui, shape, middle, stage.state, 1.21F, ground);
    const float left = shape + ui.scale.em(at.two_lines ? 1.43F : 1.07F);
    const float room = static_cast<float>(rect.right()) - left - ui.scale.em(0.43F);
    const bool dim = stage.state == State::kWaiting && !stage.current;
    const Colour& name = dim ? ui.theme.text_second : ui.theme.text;
    const FontRole role = stage.current ? FontRole::kTextStrong : FontRole::kText;
    const float apart = at.two_lines ? ui.scale.em(0.64F) : 0.0F;
    const float end =
        draw_text(ui, left, middle - apart, role, name, fitted(ui, role, stage.name, room));
    if (at.two_lines) {
        draw_text(ui, left, middle + apart, FontRole::kSmall, ui.theme.text_second,
                  fitted(ui, FontRole::kSmall, stage.criterion, room));
    } else if (at.with_criterion) {
        const float from = end + ui.scale.em(0.71F);
        draw_text(ui, from, middle, FontRole::kSmall, ui.theme.text_second,
                  fitted(ui, FontRole::kSmall, stage.criterion,
                         static_cast<float>(rect.right()) - from - ui.scale.em(0.43F)));
    }
}

/// In one line the current stage has two shares of the width, for its criterion.
int share_of(const StageText& stage, bool two_lines) {
    return stage.current && !two_lines ? 2 : 1;
}

}  // namespace

void draw_stage_bar(const Ui& ui, const Rect& rect, const Snapshot& snapshot, const Detail& detail,
                    Requests& out) {
    fill(rect, ui.theme.panel);
    const int line = static_cast<int>(ui.scale.line());
    const bool two_lines = detail.stage_criteria;
    const auto stages = stages_of(snapshot);
    int shares = 0;
    for (const StageText& stage : stages) shares += share_of(stage, two_lines);
    int done = 0;
    for (const StageText& stage : stages) {
        const int left = rect.x + rect.width * done / shares;
        done += share_of(stage, two_lines);
        const Rect at{left, rect.y, rect.x + rect.width * done / shares - left, rect.height - line};
        const auto [event, attention] = interact(ui, at, stage.id, stage.name, {}, {});
        tooltip(ui, {stage.name, {}, stage.why.empty() ? stage.criterion : stage.why});
        if (event.clicked) out.push_back(request::GoTo{stage.page});
        draw_background(ui, at, stage, attention.hovered);
        draw_words(ui, {at, two_lines, stage.current}, stage);
        if (left > rect.x) fill({left, at.y, line, at.height}, ui.theme.line);
        if (attention.focused) draw_focus_ring(ui, at.shrunk(ui.px(5)), 0.0F);
    }
    fill({rect.x, rect.bottom() - line, rect.width, line}, ui.theme.line);
}

}  // namespace gripscan::ui
