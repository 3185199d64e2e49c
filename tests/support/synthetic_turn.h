// A recorded turn whose truth is known: a lumpy body turned about an axis in front of the camera,
// sampled afresh in every view, with noise along the viewing ray.
#pragma once

#include <cmath>
#include <cstdint>
#include <numbers>
#include <vector>

#include "core/base/seeded_random.h"
#include "core/base/units.h"
#include "core/cloud/cloud.h"
#include "core/geometry/axis.h"

namespace gripscan::test {

struct SyntheticTurnSettings {
    std::uint64_t seed = 1;
    int captures = 6;
    double step_deg = 10.0;
    double noise_m = 0.2e-3;
    int samples = 16000;  ///< on the whole surface; about 40 % are seen in a view
};

/// A star-shaped body: a sphere with bumps and dents at random places, without symmetry.
class LumpyBody {
  public:
    explicit LumpyBody(std::uint64_t seed) {
        SeededRandom random(seed);
        for (int i = 0; i < 14; ++i) {
            lumps_.push_back(
                {direction(random), random.uniform(-0.20, 0.35), random.uniform(4.0, 14.0)});
        }
    }

    [[nodiscard]] static Eigen::Vector3d direction(SeededRandom& random) {
        const double z = random.uniform(-1.0, 1.0);
        const double angle = random.uniform(0.0, 2.0 * std::numbers::pi);
        const double r = std::sqrt(1.0 - z * z);
        return {r * std::cos(angle), r * std::sin(angle), z};
    }

    [[nodiscard]] double radius_m(const Eigen::Vector3d& u) const {
        double scale = 1.0;
        for (const Lump& lump : lumps_) {
            scale += lump.height * std::exp(-lump.sharpness * (u - lump.at).squaredNorm());
        }
        return 0.035 * scale;
    }

    /// Gradient of |p| − radius(p/|p|), normalised.
    [[nodiscard]] Eigen::Vector3d normal(const Eigen::Vector3d& u) const {
        Eigen::Vector3d gradient_u = Eigen::Vector3d::Zero();
        for (const Lump& lump : lumps_) {
            const double value =
                lump.height * std::exp(-lump.sharpness * (u - lump.at).squaredNorm());
            gradient_u += -2.0 * lump.sharpness * value * (u - lump.at);
        }
        const Eigen::Vector3d tangential = gradient_u - u * u.dot(gradient_u);
        return (u - 0.035 * tangential / radius_m(u)).normalized();
    }

  private:
    struct Lump {
        Eigen::Vector3d at;
        double height;
        double sharpness;
    };
    std::vector<Lump> lumps_;
};

/// The axis of the turn, nearly along the camera's x as in the cells this is made for.
[[nodiscard]] inline Axis synthetic_axis() {
    return {Eigen::Vector3d(0.01, -0.005, 0.6), Eigen::Vector3d(1.0, 0.05, -0.08).normalized()};
}

/// What the camera sees of the body after it has turned by `angle_rad`.
[[nodiscard]] inline Cloud synthetic_view(const LumpyBody& body, double angle_rad,
                                          const SyntheticTurnSettings& settings,
                                          std::uint64_t view_seed) {
    SeededRandom random(view_seed);
    const Axis axis = synthetic_axis();
    const Pose turn = turn_about(axis, angle_rad);
    // Beside the axis, as a real part is.
    const Eigen::Vector3d centre = axis.point_m + Eigen::Vector3d(0.0, 0.012, -0.006);
    Cloud cloud;
    for (int i = 0; i < settings.samples; ++i) {
        const Eigen::Vector3d u = LumpyBody::direction(random);
        const double noise_m = settings.noise_m * random.normal();
        const Eigen::Vector3d p = turn * (centre + u * body.radius_m(u));
        const Eigen::Vector3d n = turn.linear() * body.normal(u);
        if (n.dot(-p.normalized()) < 0.25) continue;
        cloud.points.push_back((p + noise_m * p.normalized()).cast<float>());
        cloud.normals.push_back(n.cast<float>());
    }
    cloud.viewpoint = Eigen::Vector3f::Zero();
    return cloud;
}

[[nodiscard]] inline std::vector<Cloud> synthetic_turn(const SyntheticTurnSettings& settings) {
    const LumpyBody body(settings.seed);
    std::vector<Cloud> views;
    for (int k = 0; k < settings.captures; ++k) {
        views.push_back(synthetic_view(body, rad_from_deg(k * settings.step_deg), settings,
                                       settings.seed * 1000 + static_cast<std::uint64_t>(k)));
    }
    return views;
}

}  // namespace gripscan::test
