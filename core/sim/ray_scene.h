// The cell's solids as something that rays can be shot at (Embree). Coordinates are FANUC WORLD,
// m. After place() any number of threads may trace.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "core/sim/scene_model.h"

namespace gripscan::sim {

struct Hit {
    float distance_m = 0.0F;
    std::uint32_t body = 0;
    std::uint32_t part = 0;   ///< index within the body
    Eigen::Vector3f normal;   ///< of the triangle, unit, in WORLD, towards the ray's origin
    Eigen::Vector3f local_m;  ///< the place in the body's frame
};

class RayScene {
  public:
    [[nodiscard]] static Result<RayScene> create(const SceneModel& model);
    RayScene(RayScene&&) noexcept;
    RayScene& operator=(RayScene&&) noexcept;
    ~RayScene();

    void place(const std::array<Pose, SceneModel::kBodies>& T_world_body);

    /// The first surface along the ray (unit direction); false if there is none.
    [[nodiscard]] bool trace(const Eigen::Vector3f& origin_m, const Eigen::Vector3f& direction,
                             Hit& hit) const;
    /// Something lies between both points (their very ends do not count).
    [[nodiscard]] bool blocked(const Eigen::Vector3f& from_m, const Eigen::Vector3f& to_m) const;

  private:
    struct Impl;
    explicit RayScene(std::unique_ptr<Impl> impl);
    std::unique_ptr<Impl> impl_;
};

}  // namespace gripscan::sim
