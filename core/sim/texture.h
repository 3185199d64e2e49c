// A solid texture: brightness of a material as a function of the place in the part, so that it
// moves with the part and looks the same to both cameras.
#pragma once

#include <Eigen/Core>
#include <cstdint>

namespace gripscan::sim {

/// Gradient noise (Perlin 2002) of several octaves, each half as large as the one before.
struct Texture {
    double cell_m = 0.012;  ///< lattice of the coarsest octave
    int octaves = 4;
    double gain = 1.25;     ///< amplitude of each octave against the coarser one
    double contrast = 0.1;  ///< standard deviation, of the mean brightness
    std::uint32_t seed = 1;
};

/// One octave: mean 0, band-limited, one cell is a unit long; standard deviation kNoiseSigma.
[[nodiscard]] float gradient_noise(const Eigen::Vector3f& p, std::uint32_t seed);
inline constexpr double kNoiseSigma = 0.2700;

/// Factor on the brightness at a place of the part: mean 1, standard deviation `contrast`.
class TextureField {
  public:
    explicit TextureField(const Texture& texture);
    [[nodiscard]] float factor(const Eigen::Vector3f& p_m) const;

  private:
    float cells_per_m_;
    float amplitude_;  ///< of the coarsest octave
    float gain_;
    int octaves_;
    std::uint32_t seed_;
};

}  // namespace gripscan::sim
