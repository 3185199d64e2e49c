#include "ui/views/navigation.h"

namespace gripscan::ui {
namespace {

ViewMotion without_shift(std::string_view preset, MouseButton button) {
    using enum ViewMotion;
    if (preset == "CAD") {
        return button == MouseButton::kMiddle  ? kOrbit
               : button == MouseButton::kRight ? kPan
                                               : kNone;
    }
    if (button == MouseButton::kLeft) return kOrbit;
    return preset == "RViz" && button == MouseButton::kRight ? kZoom : kPan;
}

}  // namespace

ViewMotion motion_of(std::string_view preset, MouseButton button, bool shift) {
    const ViewMotion motion = without_shift(preset, button);
    return shift && motion == ViewMotion::kOrbit ? ViewMotion::kPan : motion;
}

}  // namespace gripscan::ui
