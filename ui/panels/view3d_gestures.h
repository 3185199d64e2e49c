// The mouse in the 3D view: from what happened in this frame to the camera, the cuboid and the
// measured points.
#pragma once

#include <functional>
#include <optional>
#include <string_view>

#include "ui/panels/view3d_state.h"
#include "ui/render/picking.h"
#include "ui/views/navigation.h"
#include "ui/widgets/ui.h"

namespace gripscan::ui {

/// What the mouse did over the scene in this frame.
struct SceneMouse {
    bool hovered = false;  ///< over the scene, and nothing in front of it
    Eigen::Vector2d at_px = Eigen::Vector2d::Zero();  ///< on the screen
    Eigen::Vector2d moved_px = Eigen::Vector2d::Zero();
    double wheel = 0.0;
    std::optional<MouseButton> pressed;  ///< in this frame, over the scene
    bool held = false;                   ///< the button of the drag that goes on
    bool double_click = false;           ///< of the left button
    bool shift = false;
};

/// What the gestures work on.
struct SceneTarget {
    Rect rect;  ///< the half of the view under the mouse, or that of the drag
    std::string_view navigation;
    std::optional<Box> box;  ///< can be dragged
    double handle_px = 5.0;  ///< half a handle
    /// The point of a cloud under a pixel of the rectangle.
    std::function<std::optional<PickedPoint>(const Eigen::Vector2d&)> pick;
};

struct GestureResult {
    std::optional<Box> box;     ///< as it is dragged now
    bool pivot_chosen = false;  ///< its cross is to be shown
};

/// Changes camera, drag and measuring of the state.
[[nodiscard]] GestureResult take_mouse(const SceneMouse& mouse, const SceneTarget& target,
                                       View3dState& state);

/// Takes the scene's place on the screen as a control ("view3d.scene") and reads the mouse.
[[nodiscard]] SceneMouse read_mouse(const Ui& ui, const Rect& rect, const ViewDrag& drag);

[[nodiscard]] inline Viewport viewport_of(const Rect& rect) {
    return {static_cast<double>(rect.width), static_cast<double>(rect.height)};
}

}  // namespace gripscan::ui
