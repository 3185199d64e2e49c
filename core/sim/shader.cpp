#include "core/sim/shader.h"

#include <algorithm>
#include <cmath>

namespace gripscan::sim {
namespace {

/// A ray that hits nothing ends here, far outside the cell.
constexpr float kFar_m = 50.0F;

Eigen::Vector3f place_on(const Lamp& lamp, const Eigen::Vector2f& place) {
    return lamp.centre_m + place.x() * lamp.half_u_m + place.y() * lamp.half_v_m;
}

/// Where shadow rays start: off the surface by what the rounding of coordinates needs.
Eigen::Vector3f lifted(const ViewRay& ray, const Hit& hit) {
    constexpr float kLift_m = 2e-5F;
    return ray.origin_m + hit.distance_m * ray.direction + kLift_m * hit.normal;
}

}  // namespace

Shader::Shader(const SceneModel& model, Lighting lighting, const RayScene& scene,
               const RayScene& swept)
    : lighting_(std::move(lighting)), scene_(&scene), swept_(&swept) {
    for (std::size_t body = 0; body < SceneModel::kBodies; ++body) {
        for (const Part& part : model.bodies[body].parts) {
            finishes_[body].push_back({static_cast<float>(part.material.albedo),
                                       static_cast<float>(part.material.gloss),
                                       TextureField(part.material.texture)});
        }
    }
}

Shader::Light Shader::light_at(const ViewRay& ray, const Hit& hit, float gloss) const {
    constexpr float kSharpness = 24.0F;  // a broad highlight, as on blasted metal
    Light light;
    light.on_surface = lighting_.ambient * (0.75F + 0.25F * hit.normal.dot(lighting_.up));
    const Eigen::Vector3f p_m = lifted(ray, hit);
    for (const Lamp& lamp : lighting_.lamps) {
        const Eigen::Vector3f source_m = place_on(lamp, ray.lamp_place);
        const Eigen::Vector3f to_lamp = source_m - p_m;
        const float distance2 = to_lamp.squaredNorm();
        const Eigen::Vector3f l = to_lamp / std::sqrt(distance2);
        const float cosine = hit.normal.dot(l);
        if (cosine <= 0.0F || scene_->blocked(p_m, source_m)) continue;
        light.on_surface += lamp.strength * cosine / distance2;
        if (gloss > 0.0F) {  // Blinn 1977
            const float half = std::max(0.0F, hit.normal.dot((l - ray.direction).normalized()));
            light.highlight += gloss * lamp.strength * std::pow(half, kSharpness) / distance2;
        }
    }
    return light;
}

std::optional<Hit> Shader::trace(const ViewRay& ray) const {
    Hit hit;
    if (!scene_->trace(ray.origin_m, ray.direction, hit)) return std::nullopt;
    return hit;
}

float Shader::brightness(const ViewRay& ray, const std::optional<Hit>& end) const {
    if (!end) return 0.0F;
    const Finish& finish = finishes_[end->body][end->part];
    const Light light = light_at(ray, *end, finish.gloss);
    return finish.albedo * finish.texture.factor(end->local_m) * light.on_surface + light.highlight;
}

bool Shader::depends_on_joint6(const ViewRay& ray, const std::optional<Hit>& end) const {
    if (end && turns_with_joint6(end->body)) return true;
    const float length_m = end ? end->distance_m : kFar_m;
    if (swept_->blocked(ray.origin_m, ray.origin_m + length_m * ray.direction)) return true;
    if (!end) return false;
    const Eigen::Vector3f p_m = lifted(ray, *end);
    return std::any_of(lighting_.lamps.begin(), lighting_.lamps.end(), [&](const Lamp& lamp) {
        return swept_->blocked(p_m, place_on(lamp, ray.lamp_place));
    });
}

}  // namespace gripscan::sim
