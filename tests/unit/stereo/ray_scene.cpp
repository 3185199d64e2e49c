#include "tests/unit/stereo/ray_scene.h"

#include <cmath>
#include <limits>
#include <opencv2/imgproc.hpp>

#include "core/base/seeded_random.h"

namespace gripscan::test {
namespace {

constexpr int kSupersampling = 3;

struct Hit {
    double t = std::numeric_limits<double>::infinity();
    int surface = -1;
};

Hit cast(const RayScene& scene, const Eigen::Vector3d& from, const Eigen::Vector3d& direction) {
    Hit hit;
    int index = 0;
    const auto offer = [&](double t) {
        if (t > 1e-9 && t < hit.t) hit = {t, index};
    };
    for (const PlaneSurface& p : scene.planes) {
        offer((p.offset_m - p.normal.dot(from)) / p.normal.dot(direction));
        ++index;
    }
    for (const SphereSurface& s : scene.spheres) {
        const Eigen::Vector3d to_centre = s.centre_m - from;
        const double b = to_centre.dot(direction) / direction.squaredNorm();
        const double c =
            (to_centre.squaredNorm() - s.radius_m * s.radius_m) / direction.squaredNorm();
        if (b * b > c) offer(b - std::sqrt(b * b - c));
        ++index;
    }
    return hit;
}

double lattice(std::uint64_t seed, long x, long y, long z) {
    const auto mix = static_cast<std::uint64_t>(x) * 0x9e3779b97f4a7c15ULL ^
                     static_cast<std::uint64_t>(y) * 0xc2b2ae3d27d4eb4fULL ^
                     static_cast<std::uint64_t>(z) * 0x165667b19e3779f9ULL;
    return SeededRandom(seed ^ mix).uniform(-1.0, 1.0);
}

/// Smooth solid noise: random values on a lattice, blended.
double solid_noise(std::uint64_t seed, const Eigen::Vector3d& p) {
    const Eigen::Vector3d cell = p.array().floor();
    const Eigen::Vector3d f = p - cell;
    const auto fade = [](double t) { return t * t * t * (t * (6.0 * t - 15.0) + 10.0); };
    double sum = 0.0;
    for (int i = 0; i < 8; ++i) {
        const int dx = i & 1;
        const int dy = (i >> 1) & 1;
        const int dz = i >> 2;
        const double w = (dx ? fade(f.x()) : 1.0 - fade(f.x())) *
                         (dy ? fade(f.y()) : 1.0 - fade(f.y())) *
                         (dz ? fade(f.z()) : 1.0 - fade(f.z()));
        sum += w * lattice(seed, std::lround(cell.x()) + dx, std::lround(cell.y()) + dy,
                           std::lround(cell.z()) + dz);
    }
    return sum;
}

double brightness(const RayScene& scene, const Eigen::Vector3d& p_m) {
    double value = 0.0;
    double weight = 0.5;
    double grain = scene.grain_m;
    for (std::uint64_t octave = 0; octave < 3; ++octave) {
        value += weight * solid_noise(scene.seed + 77 * octave, p_m / grain);
        weight *= 0.8;
        grain *= 2.1;
    }
    return 120.0 + scene.contrast * value;
}

/// Mean brightness over the pixels' areas (whose centres are the whole numbers), before blur and
/// noise.
cv::Mat1f sharp_image(const RayScene& scene, const RectifiedRig& rig, double cx_px,
                      const Eigen::Vector3d& camera) {
    cv::Mat1f image(rig.image.height, rig.image.width);
    for (int y = 0; y < image.rows; ++y) {
        for (int x = 0; x < image.cols; ++x) {
            double sum = 0.0;
            for (int s = 0; s < kSupersampling * kSupersampling; ++s) {
                const double u = x + (s % kSupersampling + 0.5) / kSupersampling - 0.5;
                const double v = y + (s / kSupersampling + 0.5) / kSupersampling - 0.5;
                const Eigen::Vector3d ray((u - cx_px) / rig.f_px, (v - rig.cy_px) / rig.f_px, 1.0);
                const Hit hit = cast(scene, camera, ray);
                sum += hit.surface < 0 ? 20.0 : brightness(scene, camera + hit.t * ray);
            }
            image(y, x) = static_cast<float>(sum / (kSupersampling * kSupersampling));
        }
    }
    return image;
}

cv::Mat expose(const cv::Mat1f& sharp, const CameraNoise& noise, double gain, double offset,
               std::uint64_t seed) {
    cv::Mat1f blurred = sharp.clone();
    if (noise.blur_px > 0.0) {
        cv::GaussianBlur(sharp, blurred, {}, noise.blur_px, noise.blur_px, cv::BORDER_REFLECT);
    }
    SeededRandom random(seed);
    cv::Mat1b image(sharp.size());
    for (int y = 0; y < image.rows; ++y) {
        for (int x = 0; x < image.cols; ++x) {
            const double value = gain * static_cast<double>(blurred(y, x)) + offset +
                                 noise.noise_levels * random.normal();
            image(y, x) = cv::saturate_cast<uchar>(value);
        }
    }
    return image;
}

}  // namespace

RenderedPair render(const RayScene& scene, const RectifiedRig& rig, const CameraNoise& noise) {
    const Eigen::Vector3d left = Eigen::Vector3d::Zero();
    const Eigen::Vector3d right(rig.baseline_m, 0.0, 0.0);
    RenderedPair pair;
    pair.frame.left =
        expose(sharp_image(scene, rig, rig.cx_left_px, left), noise, 1.0, 0.0, scene.seed * 2 + 1);
    pair.frame.right = expose(sharp_image(scene, rig, rig.cx_right_px, right), noise,
                              noise.right_gain, noise.right_offset, scene.seed * 2 + 2);
    const cv::Size size(rig.image.width, rig.image.height);
    pair.disparity = cv::Mat1f(size, std::numeric_limits<float>::infinity());
    pair.visible_in_both = cv::Mat1b(size, uchar{0});
    pair.surface = cv::Mat1i(size, -1);
    for (int y = 0; y < size.height; ++y) {
        for (int x = 0; x < size.width; ++x) {
            const Eigen::Vector3d ray((x - rig.cx_left_px) / rig.f_px, (y - rig.cy_px) / rig.f_px,
                                      1.0);
            const Hit hit = cast(scene, left, ray);
            pair.surface(y, x) = hit.surface;
            if (hit.surface < 0) continue;
            const Eigen::Vector3d p = hit.t * ray;
            const double d = rig.disparity_px(p.z());
            pair.disparity(y, x) = static_cast<float>(d);
            const Hit back = cast(scene, right, p - right);
            const bool inside = x - d >= 0.0 && x - d <= size.width - 1.0;
            pair.visible_in_both(y, x) = inside && back.t > 1.0 - 1e-6 ? 1 : 0;
        }
    }
    return pair;
}

RectifiedRig cell_rig(int width, int height) {
    RectifiedRig rig;
    rig.image = {width, height};
    rig.f_px = 985.0;
    rig.cx_left_px = rig.cx_right_px = 0.5 * (width - 1);
    rig.cy_px = 0.5 * (height - 1);
    rig.baseline_m = 0.12;
    return rig;
}

}  // namespace gripscan::test
