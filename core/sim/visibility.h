// Which places of the turning solids the stereo camera can see at a given pose of the arm.
#pragma once

#include <array>
#include <vector>

#include "core/base/for_each.h"
#include "core/geometry/box.h"
#include "core/sim/cell_layout.h"
#include "core/sim/lens.h"
#include "core/sim/moment.h"
#include "core/sim/ray_scene.h"
#include "core/sim/surface_samples.h"

namespace gripscan::sim {

class VisibilityTest {
  public:
    /// `region` in the camera frame.
    VisibilityTest(const CellLayout& layout, const Box& region, RayScene scene);

    /// Marks the samples (given in the frame of `body`) that both cameras see at that moment.
    void mark(const Moment& moment, std::size_t body, const std::vector<SurfaceSample>& samples,
              std::vector<char>& seen, const ForEach& for_each);

    static constexpr double kSteepest_deg = 75.0;  ///< line of sight against the normal

  private:
    struct Eye {
        Lens lens;
        Pose T_eye_world;
        Eigen::Vector3d centre_m;
    };
    [[nodiscard]] bool sees(const Eye& eye, const SurfaceSample& in_world) const;

    std::array<Eye, 2> eyes_;
    Pose T_world_camera_;  ///< at the start
    Pose T_camera_world_;
    Box region_;
    RayScene scene_;
};

}  // namespace gripscan::sim
