#include "ui/panels/view3d_gestures.h"

#include <imgui.h>

#include <utility>

namespace gripscan::ui {
namespace {

using What = ViewDrag::What;
constexpr double kClick_px = 4.0;    ///< a press that moves less is a click
constexpr double kZoomPerPx = 0.05;  ///< clicks of the wheel a pixel of a zooming drag

Eigen::Vector2d inside(const Rect& rect, const Eigen::Vector2d& screen_px) {
    return screen_px - Eigen::Vector2d(rect.x, rect.y);
}

What what_of(ViewMotion motion) {
    switch (motion) {
        case ViewMotion::kOrbit:
            return What::kOrbit;
        case ViewMotion::kPan:
            return What::kPan;
        case ViewMotion::kZoom:
            return What::kZoom;
        case ViewMotion::kNone:
            break;
    }
    return What::kPoint;
}

void begin_drag(const SceneMouse& mouse, const SceneTarget& target, View3dState& state) {
    ViewDrag drag;
    drag.button = static_cast<int>(*mouse.pressed);
    drag.rect = target.rect;
    drag.what = what_of(motion_of(target.navigation, *mouse.pressed, mouse.shift));
    if (*mouse.pressed == MouseButton::kLeft && target.box) {
        const Eigen::Vector2d cursor = inside(target.rect, mouse.at_px);
        const auto handles = box_handles(*target.box, state.camera, viewport_of(target.rect));
        if (const auto face = handle_at(handles, cursor, target.handle_px)) {
            drag.what = What::kFace;
            drag.face = {*target.box, *face, cursor};
        }
    }
    state.drag = drag;
}

void move(const SceneMouse& mouse, View3dState& state, GestureResult& result) {
    const ViewDrag& drag = state.drag;
    const Viewport viewport = viewport_of(drag.rect);
    const double dx = mouse.moved_px.x();
    const double dy = mouse.moved_px.y();
    switch (drag.what) {
        case What::kOrbit:
            state.camera = orbited(state.camera, dx, dy, viewport);
            break;
        case What::kPan:
            state.camera = panned(state.camera, dx, dy, viewport);
            break;
        case What::kZoom:
            state.camera = zoomed(state.camera, -dy * kZoomPerPx,
                                  {0.5 * viewport.width_px, 0.5 * viewport.height_px}, viewport);
            break;
        case What::kFace:
            result.box =
                dragged_box(drag.face, inside(drag.rect, mouse.at_px), state.camera, viewport);
            break;
        case What::kPoint:
        case What::kNone:
            break;
    }
}

/// The button was let go: where it hardly moved it was a click.
void end_drag(const SceneMouse& mouse, const SceneTarget& target, View3dState& state) {
    const ViewDrag drag = std::exchange(state.drag, {});
    state.clicked_before = drag.travelled_px < kClick_px;
    const bool click =
        drag.button == 0 && drag.what != What::kFace && drag.travelled_px < kClick_px;
    if (!click || !state.measuring.on || !target.pick) return;
    if (const auto point = target.pick(inside(drag.rect, mouse.at_px))) {
        state.measuring = with_point(std::move(state.measuring), point->position_m);
    }
}

}  // namespace

GestureResult take_mouse(const SceneMouse& mouse, const SceneTarget& target, View3dState& state) {
    GestureResult result;
    const Eigen::Vector2d cursor = inside(target.rect, mouse.at_px);
    const auto picked = [&] { return target.pick ? target.pick(cursor) : std::nullopt; };
    if (mouse.pressed) begin_drag(mouse, target, state);
    if (state.drag.what != What::kNone) {
        state.drag.travelled_px += mouse.moved_px.norm();
        if (mouse.held) {
            move(mouse, state, result);
        } else {
            end_drag(mouse, target, state);
        }
    }
    if (mouse.double_click && state.clicked_before && !state.measuring.on) {
        if (const auto point = picked()) {
            state.camera = with_pivot(state.camera, point->position_m);
            result.pivot_chosen = true;
        }
    }
    if (mouse.hovered && mouse.wheel != 0.0) {
        const auto point = picked();
        state.camera =
            zoomed(state.camera, mouse.wheel, cursor, viewport_of(target.rect),
                   point ? std::optional<Eigen::Vector3d>(point->position_m) : std::nullopt);
    }
    return result;
}

SceneMouse read_mouse(const Ui& ui, const Rect& rect, const ViewDrag& drag) {
    ui.log.record({"view3d.scene", "3D view", rect, true, {}});
    if (rect.empty()) return {};
    ImGui::SetCursorScreenPos({static_cast<float>(rect.x), static_cast<float>(rect.y)});
    ImGui::PushAllowKeyboardFocus(false);
    ImGui::InvisibleButton("view3d.scene",
                           {static_cast<float>(rect.width), static_cast<float>(rect.height)},
                           ImGuiButtonFlags_MouseButtonLeft | ImGuiButtonFlags_MouseButtonRight |
                               ImGuiButtonFlags_MouseButtonMiddle);
    ImGui::PopAllowKeyboardFocus();
    ImGui::SetItemAllowOverlap();
    const ImGuiIO& io = ImGui::GetIO();
    SceneMouse mouse;
    mouse.hovered = ImGui::IsItemHovered();
    mouse.at_px = {io.MousePos.x, io.MousePos.y};
    mouse.moved_px = {io.MouseDelta.x, io.MouseDelta.y};
    mouse.wheel = io.MouseWheel;
    mouse.shift = io.KeyShift;
    for (const MouseButton button :
         {MouseButton::kLeft, MouseButton::kRight, MouseButton::kMiddle}) {
        if (ImGui::IsItemActivated() && ImGui::IsMouseClicked(static_cast<int>(button))) {
            mouse.pressed = button;
        }
    }
    mouse.double_click = mouse.hovered && ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left);
    const int button = mouse.pressed ? static_cast<int>(*mouse.pressed) : drag.button;
    mouse.held = ImGui::IsMouseDown(button);
    return mouse;
}

}  // namespace gripscan::ui
