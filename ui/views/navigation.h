// What a mouse button does in the 3D view, by the preset the user is used to. Pure.
#pragma once

#include <string_view>

namespace gripscan::ui {

enum class MouseButton { kLeft = 0, kRight = 1, kMiddle = 2 };
enum class ViewMotion { kNone, kOrbit, kPan, kZoom };

/// A drag with that button. Presets: "gripscan" (left orbits, right and middle pan), "CAD" (middle
/// orbits, right pans, left only points), "RViz" (left orbits, middle pans, right zooms); an
/// unknown one is the first. Shift turns an orbit into a pan.
[[nodiscard]] ViewMotion motion_of(std::string_view preset, MouseButton button, bool shift);

}  // namespace gripscan::ui
