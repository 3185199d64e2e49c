#include "ui/widgets/error_plot.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "ui/widgets/draw.h"
#include "ui/widgets/interact.h"

namespace gripscan::ui {
namespace {

/// Where values and steps lie in the picture.
struct Frame {
    Rect area;
    double half_range;
    std::size_t steps;

    [[nodiscard]] float x(std::size_t index) const {
        const double part = (static_cast<double>(index) + 0.5) / static_cast<double>(steps);
        return static_cast<float>(area.x + part * area.width);
    }
    [[nodiscard]] float y(double value) const {
        const double part = std::clamp(value / half_range, -1.0, 1.0);
        return static_cast<float>(area.y + 0.5 * area.height * (1.0 - part));
    }
};

void draw_band(const Ui& ui, const Frame& frame, std::span<const PlotPoint> points) {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const std::uint32_t colour = ui.theme.accent.with_alpha(0.28).packed();
    for (std::size_t i = 0; i + 1 < points.size(); ++i) {
        const double a = points[i].sigma;
        const double b = points[i + 1].sigma;
        if (!(a > 0.0) || !(b > 0.0)) continue;
        list.AddQuadFilled({frame.x(i), frame.y(a)}, {frame.x(i + 1), frame.y(b)},
                           {frame.x(i + 1), frame.y(-b)}, {frame.x(i), frame.y(-a)}, colour);
    }
}

void draw_path(const Ui& ui, const Frame& frame, std::span<const PlotPoint> points) {
    for (std::size_t i = 0; i + 1 < points.size(); ++i) {
        if (!std::isfinite(points[i].value) || !std::isfinite(points[i + 1].value)) continue;
        draw_line(ui, {frame.x(i), frame.y(points[i].value)},
                  {frame.x(i + 1), frame.y(points[i + 1].value)}, ui.theme.text_third);
    }
}

void draw_points(const Ui& ui, const Frame& frame, const ErrorPlot& plot) {
    const std::size_t large =
        plot.selected > 0 ? plot.selected - 1 : plot.points.size() - 1;  // wraps when empty
    for (std::size_t i = 0; i < plot.points.size(); ++i) {
        const PlotPoint& p = plot.points[i];
        if (!std::isfinite(p.value)) continue;
        const ImVec2 at{frame.x(i), frame.y(p.value)};
        if (p.state == State::kCheck || p.state == State::kReject) {
            draw_state(ui, at.x, at.y, p.state, 0.86F, ui.theme.panel);
            if (std::abs(p.value) > frame.half_range) {
                const bool left_side = i > frame.steps / 2;
                const float gap = left_side ? -ui.scale.em(0.71F) : ui.scale.em(0.71F);
                draw_text(ui, at.x + gap, at.y + ui.scale.em(0.29F), FontRole::kNumberCaption,
                          colour_of(ui.theme, p.state),
                          shown_number(p.value, 3, Sign::kAlways) + ", off scale",
                          left_side ? Align::kRight : Align::kLeft);
            }
            continue;
        }
        const bool is_large = i == large;
        const float r = ui.scale.factor() * (is_large ? 4.2F : 2.6F);
        ImGui::GetWindowDrawList()->AddCircleFilled(
            at, r, (is_large ? ui.theme.text : ui.theme.accent_text).packed(), 16);
    }
}

void draw_axes(const Ui& ui, const Frame& frame, const ErrorPlot& plot) {
    const Rect& a = frame.area;
    const float left = static_cast<float>(a.x);
    const float right = static_cast<float>(a.right());
    if (plot.points.size() < plot.steps) {
        const int from =
            static_cast<int>(frame.x(plot.points.size()) -
                             0.5F * static_cast<float>(a.width) / static_cast<float>(plot.steps));
        fill({from, a.y, a.right() - from, a.height}, ui.theme.text_third.with_alpha(0.06));
    }
    draw_line(ui, {left, frame.y(0)}, {right, frame.y(0)}, ui.theme.text_third);
    for (const double limit : {plot.limit, -plot.limit}) {
        dashed_line(ui, {left, frame.y(limit)}, {right, frame.y(limit)}, ui.theme.check, 5, 4);
        draw_text(ui, left - ui.scale.em(0.5F), frame.y(limit), FontRole::kNumberCaption,
                  ui.theme.text_third, shown_number(limit, plot.decimals, Sign::kAlways),
                  Align::kRight);
    }
    draw_text(ui, left - ui.scale.em(0.5F), frame.y(0), FontRole::kNumberCaption,
              ui.theme.text_third, "0", Align::kRight);
    for (std::size_t k = 0; k <= 4 && plot.steps >= 5; ++k) {
        const std::size_t step = k == 0 ? 1 : plot.steps * k / 4;
        draw_text(ui, frame.x(step - 1), static_cast<float>(a.bottom()) + ui.scale.em(0.71F),
                  FontRole::kNumberCaption, ui.theme.text_third, fmt::format("{}", step),
                  Align::kCentre);
    }
}

}  // namespace

double plot_half_range(const ErrorPlot& plot) {
    return plot.limit > 0.0 ? 1.5 * plot.limit : 1.0;
}

std::size_t error_plot(const Ui& ui, const Rect& rect, std::string_view id, const ErrorPlot& plot) {
    const std::size_t steps = std::max<std::size_t>({plot.steps, plot.points.size(), 1});
    const Rect area{rect.x + ui.em(3.0F), rect.y + ui.em(0.43F), rect.width - ui.em(3.57F),
                    rect.height - ui.em(1.86F)};
    if (area.empty()) return steps;
    const Frame frame{area, plot_half_range(plot), steps};
    const auto [event, attention] = interact(ui, area, id, "Error per step", {}, {});
    draw_band(ui, frame, plot.points);
    draw_axes(ui, frame, plot);
    draw_path(ui, frame, plot.points);
    draw_points(ui, frame, plot);
    if (!event.clicked) return steps;
    const double part = (static_cast<double>(ImGui::GetIO().MousePos.x) - area.x) / area.width;
    const auto index = static_cast<std::size_t>(std::max(0.0, part * static_cast<double>(steps)));
    return index < plot.points.size() ? index : steps;
}

void draw_sparkline(const Ui& ui, const Rect& rect, std::span<const PlotPoint> points,
                    double limit) {
    if (points.empty() || rect.empty()) return;
    const Frame frame{rect, limit > 0.0 ? limit : 1.0, points.size()};
    draw_line(ui, {static_cast<float>(rect.x), frame.y(0)},
              {static_cast<float>(rect.right()), frame.y(0)}, ui.theme.line2);
    draw_path(ui, frame, points);
    const PlotPoint& last = points.back();
    if (!std::isfinite(last.value)) return;
    ImGui::GetWindowDrawList()->AddCircleFilled({frame.x(points.size() - 1), frame.y(last.value)},
                                                2.0F * ui.scale.factor(),
                                                colour_of(ui.theme, last.state).packed(), 12);
}

}  // namespace gripscan::ui
