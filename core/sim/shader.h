// How bright a ray comes back: texture, lamps with soft shadows, ambient light, highlights.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "core/sim/lighting.h"
#include "core/sim/ray_scene.h"
#include "core/sim/texture.h"

namespace gripscan::sim {

/// What one ray asks: where it starts, where it goes, and which point of each lamp's panel it
/// takes (both in −1 … 1).
struct ViewRay {
    Eigen::Vector3f origin_m;
    Eigen::Vector3f direction;
    Eigen::Vector2f lamp_place;
};

/// Reads the scenes, which must outlive it; any number of threads may call it.
class Shader {
  public:
    /// `swept` holds the volume that the turning parts take up over a whole turn.
    Shader(const SceneModel& model, Lighting lighting, const RayScene& scene,
           const RayScene& swept);

    /// Where the ray ends; nothing if it leaves the cell.
    [[nodiscard]] std::optional<Hit> trace(const ViewRay& ray) const;

    /// Brightness in levels, without upper limit, of a ray that ends there; 0 outside the cell.
    [[nodiscard]] float brightness(const ViewRay& ray, const std::optional<Hit>& end) const;

    /// False if the brightness is the same at every angle of joint 6: neither the ray nor the
    /// light on its way to where the ray ends passes through the swept volume.
    [[nodiscard]] bool depends_on_joint6(const ViewRay& ray, const std::optional<Hit>& end) const;

  private:
    struct Finish {
        float albedo;
        float gloss;
        TextureField texture;
    };
    struct Light {
        float on_surface = 0.0F;
        float highlight = 0.0F;
    };
    [[nodiscard]] Light light_at(const ViewRay& ray, const Hit& hit, float gloss) const;

    std::array<std::vector<Finish>, SceneModel::kBodies> finishes_;
    Lighting lighting_;
    const RayScene* scene_;
    const RayScene* swept_;
};

}  // namespace gripscan::sim
