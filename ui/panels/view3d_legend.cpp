#include "ui/panels/view3d_legend.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <array>

#include "ui/theme/shown_number.h"
#include "ui/widgets/button.h"
#include "ui/widgets/choice.h"
#include "ui/widgets/draw.h"
#include "ui/widgets/legend.h"
#include "ui/widgets/number_input.h"

namespace gripscan::ui {
namespace {

void draw_card(const Ui& ui, const Rect& rect) {
    const float radius = ui.scale.em(0.36F);
    fill(rect, ui.theme.panel, radius);
    outline(rect, ui.theme.line, ui.scale.line(), radius);
}

/// At the lower left corner of the view.
Rect card_at(const Ui& ui, const Rect& rect, float width_em, int height) {
    const int margin = ui.em(0.71F);
    const int width = std::min(ui.em(width_em), rect.width - 2 * margin);
    return {rect.x + margin, rect.bottom() - margin - height, width, height};
}

void draw_pair(const Ui& ui, const Rect& rect, const SceneParts& parts, View3dState& state) {
    const Rect card = card_at(ui, rect, 39.0F, ui.em(3.0F));
    draw_card(ui, card);
    const float y = static_cast<float>(card.y) + 0.5F * static_cast<float>(card.height);
    float x = static_cast<float>(card.x) + ui.scale.em(1.3F);
    const float radius = ui.scale.em(0.4F);
    ImGui::GetWindowDrawList()->AddCircleFilled({x, y}, radius, ui.theme.target.packed(), 24);
    x = draw_text(ui, x + ui.scale.em(0.86F), y, FontRole::kTableStrong, ui.theme.text,
                  fmt::format("Capture {}", parts.pair_from));
    x = draw_text(ui, x + ui.scale.em(0.43F), y, FontRole::kSmall, ui.theme.text_third, "target");
    x += ui.scale.em(1.3F);
    const int side = ui.em(0.79F);
    fill({static_cast<int>(x - 0.5F * static_cast<float>(side)),
          static_cast<int>(y - 0.5F * static_cast<float>(side)), side, side},
         ui.theme.source);
    x = draw_text(ui, x + ui.scale.em(0.86F), y, FontRole::kTableStrong, ui.theme.text,
                  fmt::format("Capture {}", parts.pair_to));
    const std::array<Option, 3> options{
        {{"view3d.before", "Before"},
         {"view3d.after", "After ICP", Icon::kNone, {}, parts.why_no_aligned},
         {"view3d.at_robot", "At robot angle", Icon::kNone, {}, parts.why_no_robot}}};
    const int left = static_cast<int>(x) + ui.em(1.0F);
    const Rect place{left, card.y + (card.height - ui.em(1.86F)) / 2,
                     card.right() - ui.em(0.57F) - left, ui.em(1.86F)};
    const auto clicked =
        segments(ui, place, options, static_cast<std::size_t>(state.wish.pair_pose));
    if (clicked) state.wish.pair_pose = static_cast<PairPose>(*clicked);
}

/// "ghost of step 15" with its dash, at the right of the legend's title.
void draw_ghost_key(const Ui& ui, const Rect& card, const SceneParts& parts) {
    if (!parts.turn.next_rad) return;
    const std::string words = fmt::format("ghost of step {}", parts.steps_done + 1);
    const float y = static_cast<float>(card.y) + ui.scale.em(1.0F);
    const float right = static_cast<float>(card.right()) - ui.scale.em(0.86F);
    draw_text(ui, right, y, FontRole::kSmall, ui.theme.text_second, words, Align::kRight);
    const float end = right - text_width(ui, FontRole::kSmall, words) - ui.scale.em(0.43F);
    dashed_line(ui, {end - ui.scale.em(1.57F), y}, {end, y}, ui.theme.accent_text, 5.0F, 4.0F);
}

void draw_steps(const Ui& ui, const Rect& rect, const SceneParts& parts, bool ghost) {
    const Rect card = card_at(ui, rect, 27.5F, legend_height(ui));
    draw_legend(ui, card, {"Step", "that saw the point", "1", fmt::format("{}", parts.steps_total)},
                ColourMap::kStep, std::max(1, parts.steps_total), parts.steps_done);
    if (ghost) draw_ghost_key(ui, card, parts);
}

/// Of a recognised view: whose points are which.
void draw_match(const Ui& ui, const Rect& rect, const SceneParts& parts) {
    const Rect card = card_at(ui, rect, 30.0F, ui.em(2.43F));
    draw_card(ui, card);
    const float y = static_cast<float>(card.y) + 0.5F * static_cast<float>(card.height);
    const int side = ui.em(0.79F);
    float x = static_cast<float>(card.x) + ui.scale.em(0.86F);
    const float end = static_cast<float>(card.right()) - ui.scale.em(0.86F);
    const auto entry = [&](const Colour& colour, const std::string& words) {
        if (x + text_width(ui, FontRole::kSmall, words) + ui.scale.em(1.3F) > end) return;
        fill({static_cast<int>(x), static_cast<int>(y) - side / 2, side, side}, colour);
        x = draw_text(ui, x + ui.scale.em(1.14F), y, FontRole::kSmall, ui.theme.text_second, words);
        x += ui.scale.em(1.14F);
    };
    for (const SceneCloud& cloud : parts.clouds) {
        if (cloud.colour == nullptr) continue;
        entry(ui.theme.*cloud.colour,
              shown_count(static_cast<long long>(cloud.cloud->size())) + " points");
    }
    entry(ui.theme.text_third, "scene");
}

void draw_range_inputs(const Ui& ui, const Rect& card, const Colouring& colouring,
                       const LegendRange& range, View3dState& state) {
    const int side = ui.em(0.86F);
    const int width = ui.em(6.0F);
    const int height = ui.em(1.57F);
    const int y = card.bottom() - height - ui.em(0.5F);
    auto& typed = state.typed_ranges[static_cast<std::size_t>(colouring.by)];
    constexpr double kMost = 100000.0;
    const auto input = [&](int x, std::string_view id, std::string_view label, double value) {
        return number_input(ui, {x, y, width, height},
                            {id, label, value, colouring.unit, colouring.decimals, 0.0, kMost, {}})
            .committed;
    };
    if (const auto from = input(card.x + side, "view3d.range_from", "Low end", range.from)) {
        typed = LegendRange{*from, range.to};
    }
    if (const auto to =
            input(card.right() - side - width, "view3d.range_to", "High end", range.to)) {
        typed = LegendRange{range.from, *to};
    }
    if (!typed) return;
    const Rect reset{card.x + (card.width - ui.em(3.5F)) / 2, y, ui.em(3.5F), height};
    if (button(ui, reset, {"view3d.range_reset", "Auto"})) typed.reset();
}

void draw_continuous(const Ui& ui, const Rect& rect, const Colouring& colouring,
                     const LegendRange& range, bool grey_key, View3dState& state) {
    const int inputs = ui.em(0.86F);
    const int key = grey_key ? ui.em(1.57F) : 0;
    const Rect card = card_at(ui, rect, 21.0F, legend_height(ui) + inputs + key);
    draw_legend(ui, card, {colouring.name, colouring.meaning, {}, {}}, *colouring.map);
    Rect upper = card;
    upper.height -= key;
    draw_range_inputs(ui, upper, colouring, range, state);
    if (!grey_key) return;
    const float y = static_cast<float>(card.bottom()) - ui.scale.em(1.14F);
    const int side = ui.em(0.79F);
    fill({card.x + ui.em(0.86F), static_cast<int>(y) - side / 2, side, side}, ui.theme.too_few);
    draw_text(ui, static_cast<float>(card.x) + ui.scale.em(2.2F), y, FontRole::kSmall,
              ui.theme.text_second, "outside the cuboid, not exported");
}

}  // namespace

void draw_view3d_legend(const Ui& ui, const Rect& rect, const LegendInput& input,
                        View3dState& state) {
    const SceneParts& parts = input.parts;
    if (parts.kind == SceneKind::kEmpty) return;
    if (parts.kind == SceneKind::kPair) {
        draw_pair(ui, rect, parts, state);
        return;
    }
    if (input.by == ColourBy::kChunk) {
        draw_match(ui, rect, parts);
        return;
    }
    if (input.by == ColourBy::kStep) {
        draw_steps(ui, rect, parts, input.ghost);
        return;
    }
    const Colouring& what = colouring(input.by);
    if (what.map) {
        draw_continuous(ui, rect, what, input.range, parts.kind == SceneKind::kTemplate, state);
        return;
    }
    const Rect card = card_at(ui, rect, 20.0F, ui.em(2.0F));
    draw_card(ui, card);
    const float y = static_cast<float>(card.y) + ui.scale.em(1.0F);
    const float x = draw_text(ui, static_cast<float>(card.x) + ui.scale.em(0.86F), y,
                              FontRole::kTableStrong, ui.theme.text, what.name);
    draw_text(ui, x + ui.scale.em(0.57F), y, FontRole::kSmall, ui.theme.text_third, what.meaning);
}

void draw_measure_card(const Ui& ui, const Rect& rect, const Snapshot& snapshot,
                       const Measuring& measuring) {
    const auto lines = measure_lines(measuring, snapshot.cell.axis);
    const int row = ui.em(1.43F);
    const int height = ui.em(2.3F) + static_cast<int>(lines.size()) * row;
    const int width = ui.em(14.5F);
    const int margin = ui.em(0.71F);
    const Rect card{rect.x + margin, rect.y + ui.em(3.86F), width, height};
    draw_card(ui, card);
    ui.log.record({"view3d.measured", measure_hint(measuring), card, true, {}});
    const float left = static_cast<float>(card.x) + ui.scale.em(0.86F);
    const float right = static_cast<float>(card.right()) - ui.scale.em(0.86F);
    float y = static_cast<float>(card.y) + ui.scale.em(1.14F);
    draw_text(ui, left, y, FontRole::kSmall, ui.theme.text_second, measure_hint(measuring));
    y += ui.scale.em(0.14F);
    for (const MeasureLine& line : lines) {
        y += static_cast<float>(row);
        draw_text(ui, left, y, FontRole::kTable, ui.theme.text_second, line.label);
        draw_text(ui, right, y, FontRole::kCaption, ui.theme.text_third, line.unit, Align::kRight);
        draw_text(ui, right - ui.scale.em(2.0F), y, FontRole::kNumberTable, ui.theme.text,
                  line.value, Align::kRight);
    }
}

}  // namespace gripscan::ui
