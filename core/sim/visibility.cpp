#include "core/sim/visibility.h"

#include <cmath>

#include "core/base/units.h"

namespace gripscan::sim {

VisibilityTest::VisibilityTest(const CellLayout& layout, const Box& region, RayScene scene)
    : eyes_{Eye{Lens(layout.rig.K_left, layout.rig.D_left, layout.rig.image),
                layout.T_world_left().inverse(), layout.T_world_left().translation()},
            Eye{Lens(layout.rig.K_right, layout.rig.D_right, layout.rig.image),
                layout.T_world_right().inverse(), layout.T_world_right().translation()}},
      T_world_camera_(layout.T_world_camera),
      T_camera_world_(layout.T_world_camera.inverse()),
      region_(region),
      scene_(std::move(scene)) {}

void VisibilityTest::mark(const Moment& moment, std::size_t body,
                          const std::vector<SurfaceSample>& samples, std::vector<char>& seen,
                          const ForEach& for_each) {
    // A camera that was moved sees what one that was not would see of a cell moved the other way.
    const Pose cell_moved = T_world_camera_ * moment.T_camera_moved.inverse() * T_camera_world_;
    auto T_world_body = body_poses(moment);
    for (Pose& T : T_world_body) T = cell_moved * T;
    scene_.place(T_world_body);
    constexpr std::size_t kBlock = 1024;
    for_each((samples.size() + kBlock - 1) / kBlock, [&](std::size_t block) {
        const std::size_t end = std::min(samples.size(), (block + 1) * kBlock);
        for (std::size_t i = block * kBlock; i < end; ++i) {
            if (seen[i] != 0) continue;
            const SurfaceSample in_world = {T_world_body[body] * samples[i].point_m,
                                            T_world_body[body].linear() * samples[i].normal};
            if (!region_.contains(T_camera_world_ * in_world.point_m)) continue;
            seen[i] = sees(eyes_[0], in_world) && sees(eyes_[1], in_world) ? 1 : 0;
        }
    });
}

bool VisibilityTest::sees(const Eye& eye, const SurfaceSample& in_world) const {
    static const double kLeastCosine = std::cos(rad_from_deg(kSteepest_deg));
    const Eigen::Vector3d to_eye = (eye.centre_m - in_world.point_m).normalized();
    if (in_world.normal.dot(to_eye) < kLeastCosine) return false;
    const Eigen::Vector2d p_px = eye.lens.project(eye.T_eye_world * in_world.point_m);
    const ImageSize image = eye.lens.image();
    if (p_px.x() < 0.0 || p_px.y() < 0.0 || p_px.x() > image.width - 1 ||
        p_px.y() > image.height - 1) {
        return false;
    }
    // Half a tenth of a millimetre off the surface: coordinates are floats.
    const Eigen::Vector3d lifted_m = in_world.point_m + 5e-5 * in_world.normal;
    return !scene_.blocked(lifted_m.cast<float>(), eye.centre_m.cast<float>());
}

}  // namespace gripscan::sim
