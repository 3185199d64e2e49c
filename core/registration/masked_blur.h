// Smoothing on an image grid with holes, used to compare textures.
#pragma once

#include <vector>

namespace gripscan {

/// A grid of values that count only where `mask` is 1.
struct MaskedGrid {
    int width = 0;
    int height = 0;
    std::vector<float> mask;  ///< 0 or 1
};

/// Weighted means over the neighbourhood of every cell of the mask, holes left out; 0 outside it.
class MaskedBlur {
  public:
    /// Gaussian weights of standard deviation sigma_px; wide ones are made of boxes (Wells 1986).
    MaskedBlur(const MaskedGrid& grid, float sigma_px);
    [[nodiscard]] std::vector<float> operator()(const std::vector<float>& values) const;

  private:
    [[nodiscard]] std::vector<float> sums(const std::vector<float>& values) const;

    [[nodiscard]] std::vector<float> box_sums(std::vector<float> values) const;
    void set_weights();

    const MaskedGrid& grid_;
    std::vector<float> kernel_;  ///< empty: boxes are used
    int half_box_ = 0;
    std::vector<float> weight_;  ///< 1/sum of the weights of a cell
};

}  // namespace gripscan
