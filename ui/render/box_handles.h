// A box that is dragged by its faces.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "core/geometry/box.h"
#include "ui/render/orbit_camera.h"

namespace gripscan::ui {

/// A face: x, y or z, at its lower or upper end.
struct BoxFace {
    int axis = 0;
    bool upper = false;
    friend bool operator==(const BoxFace&, const BoxFace&) = default;
};

struct BoxHandle {
    BoxFace face;
    Eigen::Vector3d centre_m = Eigen::Vector3d::Zero();
    Eigen::Vector2d at_px = Eigen::Vector2d::Zero();
    bool behind = false;  ///< its face looks away from the eye
};
/// In the middle of every face that is in front of the eye; those behind first.
[[nodiscard]] std::vector<BoxHandle> box_handles(const Box& box, const OrbitCamera& camera,
                                                 const Viewport& viewport);
/// The handle under the cursor, those in front first.
[[nodiscard]] std::optional<BoxFace> handle_at(const std::vector<BoxHandle>& handles,
                                               const Eigen::Vector2d& cursor_px, double radius_px);

/// A drag of a face from where it began.
struct BoxDrag {
    Box box;  ///< as it was
    BoxFace face;
    Eigen::Vector2d from_px = Eigen::Vector2d::Zero();
};
/// The box while the mouse is at `to_px`: the face follows it along its normal. Never thinner than
/// `least_m`.
[[nodiscard]] Box dragged_box(const BoxDrag& drag, const Eigen::Vector2d& to_px,
                              const OrbitCamera& camera, const Viewport& viewport,
                              double least_m = 0.001);

}  // namespace gripscan::ui
