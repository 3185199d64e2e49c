#include "core/sim/texture.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace gripscan::sim {
namespace {

std::uint32_t hash_cell(std::uint32_t x, std::uint32_t y, std::uint32_t z, std::uint32_t seed) {
    std::uint32_t h = x * 0x8da6b343U ^ y * 0xd8163841U ^ z * 0xcb1ab31fU ^ seed * 0x9e3779b1U;
    h ^= h >> 16;
    h *= 0x7feb352dU;
    h ^= h >> 15;
    h *= 0x846ca68bU;
    return h ^ (h >> 16);
}

/// The edges of a cube as gradients, four of them twice (Perlin 2002).
float along_gradient(std::uint32_t hash, float x, float y, float z) {
    const std::uint32_t h = hash & 15U;
    const float u = h < 8 ? x : y;
    const float v = h < 4 ? y : (h == 12 || h == 14 ? x : z);
    return ((h & 1U) != 0 ? -u : u) + ((h & 2U) != 0 ? -v : v);
}

float fade(float t) {
    return t * t * t * (t * (t * 6.0F - 15.0F) + 10.0F);
}

float mix(float a, float b, float t) {
    return a + t * (b - a);
}

}  // namespace

float gradient_noise(const Eigen::Vector3f& p, std::uint32_t seed) {
    const float fx = std::floor(p.x());
    const float fy = std::floor(p.y());
    const float fz = std::floor(p.z());
    const auto ix = static_cast<std::uint32_t>(static_cast<std::int32_t>(fx));
    const auto iy = static_cast<std::uint32_t>(static_cast<std::int32_t>(fy));
    const auto iz = static_cast<std::uint32_t>(static_cast<std::int32_t>(fz));
    const float x = p.x() - fx;
    const float y = p.y() - fy;
    const float z = p.z() - fz;
    const auto corner = [&](std::uint32_t dx, std::uint32_t dy, std::uint32_t dz) {
        return along_gradient(hash_cell(ix + dx, iy + dy, iz + dz, seed),
                              x - static_cast<float>(dx), y - static_cast<float>(dy),
                              z - static_cast<float>(dz));
    };
    const float u = fade(x);
    const float v = fade(y);
    const float w = fade(z);
    const float near =
        mix(mix(corner(0, 0, 0), corner(1, 0, 0), u), mix(corner(0, 1, 0), corner(1, 1, 0), u), v);
    const float far =
        mix(mix(corner(0, 0, 1), corner(1, 0, 1), u), mix(corner(0, 1, 1), corner(1, 1, 1), u), v);
    return mix(near, far, w);
}

TextureField::TextureField(const Texture& texture)
    : cells_per_m_(static_cast<float>(1.0 / texture.cell_m)),
      gain_(static_cast<float>(texture.gain)),
      octaves_(texture.octaves),
      seed_(texture.seed) {
    double variance = 0.0;
    for (int i = 0; i < octaves_; ++i) variance += std::pow(texture.gain, 2 * i);
    amplitude_ = static_cast<float>(texture.contrast / (kNoiseSigma * std::sqrt(variance)));
}

float TextureField::factor(const Eigen::Vector3f& p_m) const {
    float sum = 1.0F;
    float amplitude = amplitude_;
    // The half keeps surfaces at coordinate zero off the lattice, where the noise vanishes.
    Eigen::Vector3f p = p_m * cells_per_m_ + Eigen::Vector3f::Constant(0.5F);
    for (int i = 0; i < octaves_; ++i) {
        sum += amplitude * gradient_noise(p, seed_ + static_cast<std::uint32_t>(i));
        amplitude *= gain_;
        p = p * 2.0F + Eigen::Vector3f(0.31F, 0.57F, 0.73F);
    }
    return std::max(sum, 0.05F);
}

}  // namespace gripscan::sim
