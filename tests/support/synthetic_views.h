// What a stereo camera would deliver of a solid part: organised clouds with normals, brightness and
// sigma, and noise as stereo has it, along the ray and shared by neighbouring pixels.
#pragma once

#include <cmath>
#include <cstdint>
#include <vector>

#include "core/base/for_each.h"
#include "core/base/seeded_random.h"
#include "core/cloud/cloud.h"
#include "core/cloud/filters.h"
#include "core/geometry/axis.h"
#include "tests/support/solid_part.h"

namespace gripscan::test {

struct ViewSettings {
    int width_px = 110;
    int height_px = 90;
    double focal_px = 500.0;
    double noise_m = 0.2e-3;    ///< standard deviation along the ray
    double correlation_px = 1;  ///< Gaussian that smooths the noise: related over about 3 px
    double grey_noise = 1.0;    ///< levels of 255
};

/// Noise of standard deviation 1, smoothed by a Gaussian of s px.
[[nodiscard]] inline std::vector<double> correlated_noise(int width, int height, double s,
                                                          SeededRandom& random) {
    const int reach = static_cast<int>(std::ceil(3.0 * s));
    std::vector<double> kernel;
    double squares = 0.0;
    for (int k = -reach; k <= reach; ++k) {
        kernel.push_back(std::exp(-0.5 * k * k / (s * s)));
        squares += kernel.back() * kernel.back();
    }
    // Separable: rows first, then columns; each pass keeps the variance at 1.
    const int wide = width + 2 * reach;
    std::vector<double> rows(static_cast<std::size_t>(width * (height + 2 * reach)));
    std::vector<double> white(static_cast<std::size_t>(wide));
    const auto smooth = [&](const auto& at) {
        double sum = 0.0;
        for (int k = 0; k <= 2 * reach; ++k) sum += kernel[static_cast<std::size_t>(k)] * at(k);
        return sum / std::sqrt(squares);
    };
    for (int v = 0; v < height + 2 * reach; ++v) {
        for (double& w : white) w = random.normal();
        for (int u = 0; u < width; ++u) {
            rows[static_cast<std::size_t>(v * width + u)] =
                smooth([&](int k) { return white[static_cast<std::size_t>(u + k)]; });
        }
    }
    std::vector<double> noise;
    for (int v = 0; v < height; ++v) {
        for (int u = 0; u < width; ++u) {
            noise.push_back(
                smooth([&](int k) { return rows[static_cast<std::size_t>((v + k) * width + u)]; }));
        }
    }
    return noise;
}

/// The part as the camera in the origin, looking along z, sees it.
[[nodiscard]] inline Cloud view_of(const SolidPart& part, const Pose& T_camera_part,
                                   const ViewSettings& settings, std::uint64_t noise_seed) {
    SeededRandom random(noise_seed);
    const std::vector<double> noise =
        correlated_noise(settings.width_px, settings.height_px, settings.correlation_px, random);
    const Pose T_part_camera = T_camera_part.inverse();
    Cloud cloud;
    cloud.grid_width = settings.width_px;
    cloud.grid_height = settings.height_px;
    cloud.viewpoint = Eigen::Vector3f::Zero();
    for (int cell = 0; cell < settings.width_px * settings.height_px; ++cell) {
        const Eigen::Vector3d direction =
            Eigen::Vector3d(
                (cell % settings.width_px - 0.5 * settings.width_px) / settings.focal_px,
                (cell / settings.width_px - 0.5 * settings.height_px) / settings.focal_px, 1.0)
                .normalized();
        const Ray ray{T_part_camera.translation(), T_part_camera.linear() * direction};
        const auto t = part.hit(ray);
        const double grey = settings.grey_noise * random.normal();
        if (!t) continue;
        const double shift_m = settings.noise_m * noise[static_cast<std::size_t>(cell)];
        cloud.points.push_back(((*t + shift_m) * direction).cast<float>());
        cloud.sigma.push_back(static_cast<float>(settings.noise_m));
        cloud.intensity.push_back(
            static_cast<float>(part.texture(ray.origin + *t * ray.direction) + grey));
        cloud.cell.push_back(cell);
    }
    estimate_normals(cloud, {}, for_each_in_order);
    return cloud;
}

/// The axis of the turn, nearly along the camera's x, as in the cells this is made for.
[[nodiscard]] inline Axis cell_axis() {
    return {Eigen::Vector3d(0.005, -0.004, 0.6), Eigen::Vector3d(1.0, 0.06, -0.09).normalized()};
}

/// The part's x axis laid on the axis of the turn, then turned by the angle.
[[nodiscard]] inline Pose part_turned(const Axis& axis, double angle_rad) {
    Pose T = Pose::Identity();
    T.linear() = Eigen::Quaterniond::FromTwoVectors(Eigen::Vector3d::UnitX(), axis.direction)
                     .toRotationMatrix();
    T.translation() = axis.point_m;
    return turn_about(axis, angle_rad) * T;
}

/// Two views of a part, with the truth between them.
struct ViewPair {
    Cloud source;
    Cloud target;
    Pose T_target_source;
};

[[nodiscard]] inline ViewPair pair_of_views(const SolidPart& part, const Axis& axis,
                                            double from_rad, double to_rad, std::uint64_t seed,
                                            const ViewSettings& settings = {}) {
    return {view_of(part, part_turned(axis, from_rad), settings, 2 * seed + 1),
            view_of(part, part_turned(axis, to_rad), settings, 2 * seed + 2),
            turn_about(axis, to_rad - from_rad)};
}

}  // namespace gripscan::test
