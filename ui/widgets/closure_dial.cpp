#include "ui/widgets/closure_dial.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "ui/widgets/draw.h"

namespace gripscan::ui {
namespace {

constexpr float kPi = std::numbers::pi_v<float>;

/// From the top, clockwise; `whole` is one time around.
float screen_angle(double angle_deg, double whole_deg) {
    return static_cast<float>(angle_deg / whole_deg) * 2.0F * kPi - 0.5F * kPi;
}

ImVec2 at(ImVec2 centre, float radius, float angle) {
    return {centre.x + radius * std::cos(angle), centre.y + radius * std::sin(angle)};
}

struct Ring {
    ImVec2 centre;
    float radius;  ///< of its middle
    float width;
    double whole_deg;

    void arc(double from_deg, double to_deg, const Colour& colour) const {
        if (to_deg <= from_deg) return;
        ImDrawList& list = *ImGui::GetWindowDrawList();
        const int steps = std::max(3, static_cast<int>(128.0 * (to_deg - from_deg) / whole_deg));
        list.PathArcTo(centre, radius, screen_angle(from_deg, whole_deg),
                       screen_angle(to_deg, whole_deg), steps);
        list.PathStroke(colour.packed(), 0, width);
    }
    void dashes(double from_deg, double to_deg, const Colour& colour) const {
        const double dash = 0.006 * whole_deg;
        for (double a = from_deg; a < to_deg; a += 2.0 * dash) {
            arc(a, std::min(a + dash, to_deg), colour);
        }
    }
};

void draw_ticks(const Ui& ui, ImVec2 centre, float inner, float length, double part) {
    constexpr int kTicks = 36;
    for (int i = 0; i < kTicks; ++i) {
        const double here = static_cast<double>(i) / kTicks;
        const float angle = screen_angle(here, 1.0);
        const Colour& colour = here <= part ? ui.theme.text_third : ui.theme.line2;
        draw_line(ui, at(centre, inner, angle), at(centre, inner + length, angle), colour);
    }
}

}  // namespace

void draw_closure_dial(const Ui& ui, const Rect& rect, const DialState& dial) {
    const double whole = dial.whole_deg > 0.0 ? dial.whole_deg : 360.0;
    const ImVec2 centre{static_cast<float>(rect.x) + 0.5F * static_cast<float>(rect.width),
                        static_cast<float>(rect.y) + 0.5F * static_cast<float>(rect.height)};
    const float outer = 0.5F * static_cast<float>(std::min(rect.width, rect.height));
    const float tick = ui.scale.px(3.0F);
    const float width = ui.scale.px(8.0F);
    const Ring ring{centre, outer - tick - ui.scale.px(4.0F) - 0.5F * width, width, whole};
    const double turned = std::clamp(dial.turned_deg, 0.0, whole);

    draw_ticks(ui, centre, outer - tick, tick, turned / whole);
    ring.arc(0.0, whole, ui.theme.hover);
    ring.arc(0.0, turned, ui.theme.ok);
    if (dial.refused_deg > 0.0) {
        ring.dashes(turned, std::min(turned + dial.refused_deg, whole), ui.theme.reject);
    } else if (dial.next_deg > 0.0) {
        ring.arc(turned, std::min(turned + dial.next_deg, whole), ui.theme.accent);
    }
    const float needle = screen_angle(dial.robot_deg, whole);
    draw_line(ui, at(centre, ring.radius - width, needle), at(centre, ring.radius + width, needle),
              ui.theme.text, ui.scale.px(2.0F));
    draw_text(ui, centre.x, centre.y - ui.scale.em(0.29F), FontRole::kDial, ui.theme.text,
              shown_number(dial.turned_deg, 0) + "°", Align::kCentre);
    draw_text(ui, centre.x, centre.y + ui.scale.em(0.93F), FontRole::kCaption, ui.theme.text_second,
              "of " + shown_number(whole, 0) + "°", Align::kCentre);
}

}  // namespace gripscan::ui
