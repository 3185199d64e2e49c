#include "ui/widgets/state_shape.h"

#include <imgui.h>

#include <array>
#include <cmath>
#include <numbers>

namespace gripscan::ui {
namespace {

constexpr float kTurn = 2.0F * std::numbers::pi_v<float>;

struct Pen {
    ImDrawList& list;
    ImVec2 centre;
    float r;
    std::uint32_t colour;
    std::uint32_t mark;
    float stroke;

    [[nodiscard]] ImVec2 at(float x, float y) const { return {centre.x + x * r, centre.y + y * r}; }
};

void accept(const Pen& pen) {
    pen.list.AddCircleFilled(pen.centre, pen.r, pen.colour, 32);
    const std::array tick{pen.at(-0.45F, 0.03F), pen.at(-0.13F, 0.36F), pen.at(0.48F, -0.32F)};
    pen.list.AddPolyline(tick.data(), 3, pen.mark, 0, pen.stroke);
}

void check(const Pen& pen) {
    pen.list.PathLineTo(pen.at(0.0F, -0.92F));
    pen.list.PathLineTo(pen.at(1.02F, 0.85F));
    pen.list.PathLineTo(pen.at(-1.02F, 0.85F));
    pen.list.PathFillConvex(pen.colour);
    pen.list.AddLine(pen.at(0.0F, -0.32F), pen.at(0.0F, 0.30F), pen.mark, pen.stroke);
    pen.list.AddCircleFilled(pen.at(0.0F, 0.60F), 0.55F * pen.stroke, pen.mark, 12);
}

void reject(const Pen& pen) {
    for (int i = 0; i < 8; ++i) {
        const float angle = (static_cast<float>(i) + 0.5F) * kTurn / 8.0F;
        pen.list.PathLineTo(pen.at(1.04F * std::cos(angle), 1.04F * std::sin(angle)));
    }
    pen.list.PathFillConvex(pen.colour);
    pen.list.AddLine(pen.at(-0.36F, -0.36F), pen.at(0.36F, 0.36F), pen.mark, pen.stroke);
    pen.list.AddLine(pen.at(-0.36F, 0.36F), pen.at(0.36F, -0.36F), pen.mark, pen.stroke);
}

void running(const Pen& pen, double time_s) {
    constexpr double kTurn_s = 1.2;
    const float start =
        -0.25F * kTurn + kTurn * static_cast<float>(std::fmod(time_s, kTurn_s) / kTurn_s);
    const float width = 0.22F * pen.r;
    pen.list.AddCircle(pen.centre, pen.r - 0.5F * width, pen.colour, 32, width);
    pen.list.PathLineTo(pen.centre);
    pen.list.PathArcTo(pen.centre, pen.r - 0.5F * width, start, start + kTurn / 3.0F, 16);
    pen.list.PathFillConvex(pen.colour);
}

void waiting(const Pen& pen) {
    constexpr int kDashes = 8;
    const float width = 0.20F * pen.r;
    for (int i = 0; i < kDashes; ++i) {
        const float from = static_cast<float>(i) * kTurn / kDashes;
        pen.list.PathArcTo(pen.centre, pen.r - 0.5F * width, from, from + 0.55F * kTurn / kDashes,
                           6);
        pen.list.PathStroke(pen.colour, 0, width);
    }
}

}  // namespace

void draw_state(const Ui& ui, float x, float y, State state, float diameter_em,
                const Colour& mark) {
    const float r = 0.5F * diameter_em * kTextSizePx * ui.scale.factor();
    const Pen pen{*ImGui::GetWindowDrawList(),         {x, y},        r,
                  colour_of(ui.theme, state).packed(), mark.packed(), std::max(1.0F, 0.26F * r)};
    switch (state) {
        case State::kAccept:
            return accept(pen);
        case State::kCheck:
            return check(pen);
        case State::kReject:
            return reject(pen);
        case State::kRunning:
            return running(pen, ui.time_s);
        case State::kWaiting:
            return waiting(pen);
    }
}

}  // namespace gripscan::ui
