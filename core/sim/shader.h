// How bright a ray comes back: texture, lamps with soft shadows, ambient light, highlights.
#pragma once

#include <array>
#include <vector>

#include "core/sim/lighting.h"
#include "core/sim/ray_scene.h"
#include "core/sim/texture.h"

namespace gripscan::sim {

/// A place on a lamp, both in −1 … 1: which point of each panel this ray asks.
using LampSample = Eigen::Vector2f;

/// Reads `scene`, which must outlive it; any number of threads may call it.
class Shader {
  public:
    Shader(const SceneModel& model, Lighting lighting, const RayScene& scene);

    /// Brightness in levels, without upper limit; 0 where the ray leaves the cell.
    [[nodiscard]] float brightness(const Eigen::Vector3f& origin_m,
                                   const Eigen::Vector3f& direction, const LampSample& at) const;

  private:
    struct Finish {
        float albedo;
        float gloss;
        TextureField texture;
    };
    [[nodiscard]] float light(const Eigen::Vector3f& p_m, const Hit& hit,
                              const Eigen::Vector3f& direction, float gloss, const LampSample& at,
                              float& highlight) const;

    std::array<std::vector<Finish>, SceneModel::kBodies> finishes_;
    Lighting lighting_;
    const RayScene* scene_;
};

}  // namespace gripscan::sim
