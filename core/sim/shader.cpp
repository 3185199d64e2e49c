#include "core/sim/shader.h"

#include <algorithm>
#include <cmath>

namespace gripscan::sim {

Shader::Shader(const SceneModel& model, Lighting lighting, const RayScene& scene)
    : lighting_(std::move(lighting)), scene_(&scene) {
    for (std::size_t body = 0; body < SceneModel::kBodies; ++body) {
        for (const Part& part : model.bodies[body].parts) {
            finishes_[body].push_back({static_cast<float>(part.material.albedo),
                                       static_cast<float>(part.material.gloss),
                                       TextureField(part.material.texture)});
        }
    }
}

float Shader::light(const Eigen::Vector3f& p_m, const Hit& hit, const Eigen::Vector3f& direction,
                    float gloss, const LampSample& at, float& highlight) const {
    const float facing_up = hit.normal.dot(lighting_.up);
    float sum = lighting_.ambient * (0.75F + 0.25F * facing_up);
    const Eigen::Vector3f lifted_m = p_m + 2e-5F * hit.normal;
    for (const Lamp& lamp : lighting_.lamps) {
        const Eigen::Vector3f source_m =
            lamp.centre_m + at.x() * lamp.half_u_m + at.y() * lamp.half_v_m;
        const Eigen::Vector3f to_lamp = source_m - p_m;
        const float distance2 = to_lamp.squaredNorm();
        const Eigen::Vector3f l = to_lamp / std::sqrt(distance2);
        const float cosine = hit.normal.dot(l);
        if (cosine <= 0.0F || scene_->blocked(lifted_m, source_m)) continue;
        sum += lamp.strength * cosine / distance2;
        if (gloss > 0.0F) {  // Blinn 1977; a broad highlight, as on blasted metal
            const float half = std::max(0.0F, hit.normal.dot((l - direction).normalized()));
            const float h8 = std::pow(half, 24.0F);
            highlight += gloss * lamp.strength * h8 / distance2;
        }
    }
    return sum;
}

float Shader::brightness(const Eigen::Vector3f& origin_m, const Eigen::Vector3f& direction,
                         const LampSample& at) const {
    Hit hit;
    if (!scene_->trace(origin_m, direction, hit)) return 0.0F;
    const Finish& finish = finishes_[hit.body][hit.part];
    const Eigen::Vector3f p_m = origin_m + hit.distance_m * direction;
    float highlight = 0.0F;
    const float sum = light(p_m, hit, direction, finish.gloss, at, highlight);
    return finish.albedo * finish.texture.factor(hit.local_m) * sum + highlight;
}

}  // namespace gripscan::sim
