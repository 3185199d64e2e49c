#include "ui/render/box_handles.h"

#include <algorithm>

namespace gripscan::ui {
namespace {

Eigen::Vector3d normal_of(const BoxFace& face) {
    return (face.upper ? 1.0 : -1.0) * Eigen::Vector3d::Unit(face.axis);
}

Eigen::Vector3d middle_of(const Box& box, const BoxFace& face) {
    Eigen::Vector3d middle = 0.5 * (box.min_m + box.max_m);
    middle(face.axis) = face.upper ? box.max_m(face.axis) : box.min_m(face.axis);
    return middle;
}

/// How far along the line p + s · n the ray through a pixel passes nearest; nothing where both run
/// the same way.
std::optional<double> along_line(const Eigen::Vector3d& p, const Eigen::Vector3d& n,
                                 const Eigen::Vector2d& px, const OrbitCamera& camera,
                                 const Viewport& viewport) {
    const Eigen::Vector3d eye = camera.eye_m();
    const Eigen::Vector3d ray =
        (unproject(camera, viewport, px, camera.distance_m) - eye).normalized();
    const double cosine = n.dot(ray);
    const double sine_squared = 1.0 - cosine * cosine;
    constexpr double kLeast = 1e-4;  // half a degree: beyond it the face would leap
    if (sine_squared < kLeast) return std::nullopt;
    const Eigen::Vector3d w = eye - p;
    return (w.dot(n) - cosine * w.dot(ray)) / sine_squared;
}

}  // namespace

std::vector<BoxHandle> box_handles(const Box& box, const OrbitCamera& camera,
                                   const Viewport& viewport) {
    std::vector<BoxHandle> handles;
    if (!box.valid()) return handles;
    for (int axis = 0; axis < 3; ++axis) {
        for (const bool upper : {false, true}) {
            const BoxFace face{axis, upper};
            const Eigen::Vector3d middle = middle_of(box, face);
            const auto px = project(camera, viewport, middle);
            if (!px) continue;
            const bool behind = normal_of(face).dot(camera.eye_m() - middle) < 0.0;
            handles.push_back({face, middle, *px, behind});
        }
    }
    std::stable_sort(handles.begin(), handles.end(),
                     [](const BoxHandle& a, const BoxHandle& b) { return a.behind && !b.behind; });
    return handles;
}

std::optional<BoxFace> handle_at(const std::vector<BoxHandle>& handles,
                                 const Eigen::Vector2d& cursor_px, double radius_px) {
    for (auto handle = handles.rbegin(); handle != handles.rend(); ++handle) {
        if ((handle->at_px - cursor_px).cwiseAbs().maxCoeff() <= radius_px) return handle->face;
    }
    return std::nullopt;
}

Box dragged_box(const BoxDrag& drag, const Eigen::Vector2d& to_px, const OrbitCamera& camera,
                const Viewport& viewport, double least_m) {
    const Eigen::Vector3d middle = middle_of(drag.box, drag.face);
    const Eigen::Vector3d n = Eigen::Vector3d::Unit(drag.face.axis);
    const auto from = along_line(middle, n, drag.from_px, camera, viewport);
    const auto to = along_line(middle, n, to_px, camera, viewport);
    if (!from || !to) return drag.box;
    Box box = drag.box;
    const int axis = drag.face.axis;
    if (drag.face.upper) {
        box.max_m(axis) = std::max(box.max_m(axis) + (*to - *from), box.min_m(axis) + least_m);
    } else {
        box.min_m(axis) = std::min(box.min_m(axis) + (*to - *from), box.max_m(axis) - least_m);
    }
    return box;
}

}  // namespace gripscan::ui
