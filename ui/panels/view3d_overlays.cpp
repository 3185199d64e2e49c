#include "ui/panels/view3d_overlays.h"

#include <imgui.h>

#include <algorithm>
#include <array>

#include "ui/panels/view3d_gestures.h"
#include "ui/render/scale_bar.h"
#include "ui/theme/shown_number.h"
#include "ui/widgets/draw.h"
#include "ui/widgets/rich_text.h"

namespace gripscan::ui {
namespace {

std::optional<ImVec2> on_screen(const Rect& rect, const OrbitCamera& camera,
                                const Eigen::Vector3d& point_m) {
    const auto px = project(camera, viewport_of(rect), point_m);
    if (!px) return std::nullopt;
    return ImVec2{static_cast<float>(rect.x + px->x()), static_cast<float>(rect.y + px->y())};
}

void draw_marker(const Ui& ui, const ImVec2& at, std::string_view name) {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const float radius = ui.scale.px(5.0F);
    list.AddCircleFilled(at, radius + ui.scale.px(1.5F), ui.theme.view_bottom.packed(), 24);
    list.AddCircle(at, radius, ui.theme.accent_text.packed(), 24, ui.scale.px(1.6F));
    list.AddCircleFilled(at, ui.scale.px(1.5F), ui.theme.accent_text.packed(), 12);
    draw_outlined(ui, at.x + ui.scale.px(10.0F), at.y - ui.scale.px(8.0F), ui.theme.accent_text,
                  name);
}

/// Moved down until it covers none of those that have their place.
Rect below_all(Rect words, const std::vector<Rect>& placed) {
    const auto covered = [&] {
        return std::find_if(placed.begin(), placed.end(),
                            [&](const Rect& other) { return words.overlaps(other); });
    };
    for (auto other = covered(); other != placed.end(); other = covered()) {
        words.y = other->bottom();
    }
    return words;
}

}  // namespace

float draw_outlined(const Ui& ui, float x, float y, const Colour& colour, std::string_view text,
                    bool ends_there) {
    const Align align = ends_there ? Align::kRight : Align::kLeft;
    const float reach = std::max(1.0F, ui.scale.px(1.5F));
    for (int dy = -1; dy <= 1; ++dy) {
        for (int dx = -1; dx <= 1; ++dx) {
            if (dx == 0 && dy == 0) continue;
            draw_text(ui, x + static_cast<float>(dx) * reach, y + static_cast<float>(dy) * reach,
                      FontRole::kTableStrong, ui.theme.view_bottom, text, align);
        }
    }
    return draw_text(ui, x, y, FontRole::kTableStrong, colour, text, align);
}

void draw_labels(const Ui& ui, const Rect& rect, const OrbitCamera& camera,
                 const std::vector<SceneLabel>& labels) {
    std::vector<Rect> placed;
    for (const SceneLabel& label : labels) {
        const auto at = on_screen(rect, camera, label.at_m);
        if (!at || !rect.contains(static_cast<int>(at->x), static_cast<int>(at->y))) continue;
        const bool ends_there = label.dx_px < 0.0;
        const float wide = std::max(text_width(ui, FontRole::kTableStrong, label.text),
                                    text_width(ui, FontRole::kTableStrong, label.second));
        const float margin = ui.scale.em(0.57F);
        // Words that would leave the view at the left stand right of their place.
        const float x_wanted = at->x + static_cast<float>(label.dx_px) * ui.scale.factor();
        const float least = static_cast<float>(rect.x) + margin + (ends_there ? wide : 0.0F);
        const float x = std::max(x_wanted, least);
        const float y_wanted = at->y + static_cast<float>(label.dy_px) * ui.scale.factor();
        const float line = ui.scale.em(1.14F);
        const float high = label.second.empty() ? line : 2.0F * line;
        const Rect words =
            below_all({static_cast<int>(ends_there ? x - wide : x), static_cast<int>(y_wanted),
                       static_cast<int>(wide) + 1, static_cast<int>(high) + 1},
                      placed);
        placed.push_back(words);
        const float y = y_wanted + static_cast<float>(words.y - static_cast<int>(y_wanted));
        draw_outlined(ui, x, y, label.colour, label.text, ends_there);
        if (!label.second.empty()) {
            draw_outlined(ui, x, y + line, ui.theme.text_second, label.second, ends_there);
        }
    }
}

void draw_handles(const Ui& ui, const Rect& rect, const Box& box, const OrbitCamera& camera,
                  const std::optional<BoxFace>& dragged) {
    const int half = ui.px(5);
    for (const BoxHandle& handle : box_handles(box, camera, viewport_of(rect))) {
        const Rect square{rect.x + static_cast<int>(handle.at_px.x()) - half,
                          rect.y + static_cast<int>(handle.at_px.y()) - half, 2 * half, 2 * half};
        if (!square.inside(rect)) continue;
        const Colour& colour = dragged == handle.face ? ui.theme.text : ui.theme.accent;
        if (handle.behind) {
            fill(square, ui.theme.view_bottom);
            outline(square, colour, ui.scale.px(1.6F));
        } else {
            outline(square.shrunk(-static_cast<int>(ui.scale.line())), ui.theme.view_bottom,
                    ui.scale.line());
            fill(square, colour);
        }
    }
}

void draw_measured(const Ui& ui, const Rect& rect, const Measuring& measuring,
                   const OrbitCamera& camera) {
    constexpr std::array kNames{"A", "B"};
    std::vector<ImVec2> places;
    for (const Eigen::Vector3d& point : measuring.points_m) {
        if (const auto at = on_screen(rect, camera, point)) places.push_back(*at);
    }
    if (places.size() == 2) {
        draw_line(ui, places[0], places[1], ui.theme.view_bottom, ui.scale.px(4.0F));
        draw_line(ui, places[0], places[1], ui.theme.accent_text, ui.scale.px(1.6F));
    }
    for (std::size_t i = 0; i < places.size(); ++i) draw_marker(ui, places[i], kNames[i]);
}

int draw_triad(const Ui& ui, const Rect& rect, const OrbitCamera& camera) {
    const float length = ui.scale.px(24.0F);
    const ImVec2 centre{static_cast<float>(rect.right()) - ui.scale.px(46.0F),
                        static_cast<float>(rect.bottom()) - ui.scale.px(46.0F)};
    struct Arm {
        Eigen::Vector3d in_view;
        Colour colour;
        std::string_view name;
    };
    const Eigen::Matrix3d R_view_world = camera.R_world_view().transpose();
    std::array<Arm, 3> arms{{{R_view_world.col(0), ui.theme.axis_x, "X"},
                             {R_view_world.col(1), ui.theme.axis_y, "Y"},
                             {R_view_world.col(2), ui.theme.axis_z, "Z"}}};
    std::sort(arms.begin(), arms.end(),
              [](const Arm& a, const Arm& b) { return a.in_view.z() > b.in_view.z(); });
    for (const Arm& arm : arms) {
        const ImVec2 way{static_cast<float>(arm.in_view.x()), static_cast<float>(arm.in_view.y())};
        draw_line(ui, centre, {centre.x + length * way.x, centre.y + length * way.y}, arm.colour,
                  ui.scale.px(1.8F));
        // The letter beyond the end, and beside it where the arm points at the viewer.
        const float beyond = length + ui.scale.px(9.0F);
        draw_text(ui, centre.x + beyond * way.x, centre.y + beyond * way.y, FontRole::kTableStrong,
                  arm.colour, arm.name, Align::kCentre);
    }
    return static_cast<int>(centre.x - ui.scale.px(46.0F));
}

void draw_scale_bar(const Ui& ui, int right, const Rect& rect, const OrbitCamera& camera) {
    const ScaleBar bar = scale_bar(camera.px_per_m(viewport_of(rect)), ui.scale.px(128.0F));
    if (!(bar.length_px > 1.0)) return;
    const Rect card{right - ui.px(150), rect.bottom() - ui.px(10) - ui.px(34), ui.px(150),
                    ui.px(34)};
    fill(card, ui.theme.view_bottom.with_alpha(0.8), ui.scale.em(0.36F));
    const float middle = static_cast<float>(card.x) + 0.5F * static_cast<float>(card.width);
    const float half = 0.5F * static_cast<float>(bar.length_px);
    const float y = static_cast<float>(card.bottom()) - ui.scale.px(8.0F);
    const float tick = ui.scale.px(6.0F);
    draw_line(ui, {middle - half, y}, {middle + half, y}, ui.theme.text_second);
    draw_line(ui, {middle - half, y - tick}, {middle - half, y}, ui.theme.text_second);
    draw_line(ui, {middle + half, y - tick}, {middle + half, y}, ui.theme.text_second);
    const int decimals = bar.length_mm < 1.0 ? 2 : 0;
    draw_text(ui, middle, static_cast<float>(card.y) + ui.scale.px(12.0F), FontRole::kNumberSmall,
              ui.theme.text_second, shown_number(bar.length_mm, decimals) + " mm", Align::kCentre);
}

void draw_message(const Ui& ui, const Rect& rect, std::string_view title, std::string_view text) {
    const int width = std::min(ui.em(26.0F), rect.width - 2 * ui.em(1.0F));
    if (width <= 0) return;
    const float middle = static_cast<float>(rect.x) + 0.5F * static_cast<float>(rect.width);
    const int y = rect.y + rect.height / 2 - ui.em(1.5F);
    draw_text(ui, middle, static_cast<float>(y), FontRole::kVerdict, ui.theme.text_second, title,
              Align::kCentre);
    const int top = y + ui.em(1.3F);
    if (text_width(ui, FontRole::kText, text) <= static_cast<float>(width)) {
        draw_text(ui, middle, static_cast<float>(top) + ui.scale.em(0.75F), FontRole::kText,
                  ui.theme.text_third, text, Align::kCentre);
    } else {
        draw_rich_text(ui, static_cast<int>(middle) - width / 2, top, width, ui.theme.text_third,
                       text);
    }
}

}  // namespace gripscan::ui
