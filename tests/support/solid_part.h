// Parts for synthetic scenes: unions of boxes and cylinders with a texture that belongs to the
// material, so that it turns with the part. Rays meet them exactly; nothing is sampled or meshed.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <optional>
#include <vector>

#include "core/base/seeded_random.h"
#include "core/geometry/pose.h"

namespace gripscan::test {

struct Ray {
    Eigen::Vector3d origin;
    Eigen::Vector3d direction;  ///< unit
};

/// A box, or a cylinder whose axis is x, about `centre`; half extents in m (a cylinder's radius is
/// half.y()).
struct Primitive {
    enum class Kind { kBox, kCylinder } kind = Kind::kBox;
    Eigen::Vector3d centre = Eigen::Vector3d::Zero();
    Eigen::Vector3d half = Eigen::Vector3d::Zero();

    /// Distance along the ray to where it enters; nothing where it misses.
    [[nodiscard]] std::optional<double> hit(const Ray& ray) const {
        const Eigen::Vector3d o = ray.origin - centre;
        double near = 0.0;
        double far = std::numeric_limits<double>::infinity();
        const auto clip = [&](double a, double b) {
            near = std::max(near, std::min(a, b));
            far = std::min(far, std::max(a, b));
        };
        for (int k = 0; k < (kind == Kind::kBox ? 3 : 1); ++k) {
            clip((-half(k) - o(k)) / ray.direction(k), (half(k) - o(k)) / ray.direction(k));
        }
        if (kind == Kind::kCylinder) {
            const Eigen::Vector2d d = ray.direction.tail<2>();
            const double b = o.tail<2>().dot(d) / d.squaredNorm();
            const double c = (o.tail<2>().squaredNorm() - half.y() * half.y()) / d.squaredNorm();
            if (b * b < c) return std::nullopt;
            clip(-b - std::sqrt(b * b - c), -b + std::sqrt(b * b - c));
        }
        if (near > far || near <= 0.0) return std::nullopt;
        return near;
    }
};

/// A sum of waves of random direction and length: no two places look alike.
class SolidTexture {
  public:
    /// `contrast`: standard deviation in levels of 255; 0: plain.
    SolidTexture(std::uint64_t seed, double contrast) : contrast_(contrast) {
        SeededRandom random(seed);
        for (Wave& wave : waves_) {
            Eigen::Vector3d direction(random.normal(), random.normal(), random.normal());
            const double length_m = random.uniform(5.0e-3, 20.0e-3);
            wave.k = direction.normalized() * (2.0 * std::numbers::pi / length_m);
            wave.phase = random.uniform(0.0, 2.0 * std::numbers::pi);
        }
    }
    [[nodiscard]] double operator()(const Eigen::Vector3d& p) const {
        double sum = 0.0;
        for (const Wave& wave : waves_) sum += std::cos(wave.k.dot(p) + wave.phase);
        return 128.0 + contrast_ * sum * std::sqrt(2.0 / static_cast<double>(waves_.size()));
    }

  private:
    struct Wave {
        Eigen::Vector3d k;
        double phase = 0.0;
    };
    std::array<Wave, 16> waves_;
    double contrast_;
};

struct SolidPart {
    std::vector<Primitive> primitives;
    SolidTexture texture{1, 25.0};

    [[nodiscard]] std::optional<double> hit(const Ray& ray) const {
        std::optional<double> nearest;
        for (const Primitive& primitive : primitives) {
            const auto t = primitive.hit(ray);
            if (t && (!nearest || *t < *nearest)) nearest = t;
        }
        return nearest;
    }
};

/// A gripper of sorts along x: flange, palm, two unequal fingers, and details at random places.
[[nodiscard]] inline SolidPart asymmetric_part(std::uint64_t seed, double contrast = 25.0) {
    using enum Primitive::Kind;
    SeededRandom random(seed);
    SolidPart part{{}, SolidTexture(seed + 1000, contrast)};
    part.primitives = {
        {kCylinder, {-0.045, 0.0, 0.0}, {0.010, 0.025, 0.025}},
        {kBox, {-0.015, 0.008, -0.006}, {0.022, 0.034, random.uniform(0.016, 0.022)}},
        {kBox, {0.030, 0.026, 0.003}, {0.026, 0.007, 0.012}},
        {kBox, {0.026, -0.022, -0.012}, {0.022, 0.009, random.uniform(0.009, 0.013)}},
    };
    for (int i = 0; i < 7; ++i) {
        const double angle = random.uniform(0.0, 2.0 * std::numbers::pi);
        const Eigen::Vector3d centre(random.uniform(-0.035, 0.01), 0.028 * std::cos(angle),
                                     0.022 * std::sin(angle));
        const Eigen::Vector3d half(random.uniform(4e-3, 9e-3), random.uniform(4e-3, 9e-3),
                                   random.uniform(4e-3, 9e-3));
        part.primitives.push_back({i % 3 == 0 ? kCylinder : kBox, centre, half});
    }
    return part;
}

/// Turned on a lathe about x: looks the same after every turn about it, but for the texture.
[[nodiscard]] inline SolidPart part_of_revolution(std::uint64_t seed, double contrast) {
    using enum Primitive::Kind;
    return {{{kCylinder, {-0.035, 0.0, 0.0}, {0.010, 0.035, 0.035}},
             {kCylinder, {0.0, 0.0, 0.0}, {0.050, 0.022, 0.022}},
             {kCylinder, {0.030, 0.0, 0.0}, {0.012, 0.028, 0.028}}},
            SolidTexture(seed, contrast)};
}

}  // namespace gripscan::test
