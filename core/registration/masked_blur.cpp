#include "core/registration/masked_blur.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace gripscan {

MaskedBlur::MaskedBlur(const MaskedGrid& grid, float sigma_px) : grid_(grid) {
    const int reach = std::max(1, static_cast<int>(std::lround(2.2F * sigma_px)));
    for (int k = -reach; k <= reach; ++k) {
        kernel_.push_back(std::exp(-0.5F * static_cast<float>(k * k) / (sigma_px * sigma_px)));
    }
    weight_ = sums(grid.mask);
    for (std::size_t i = 0; i < weight_.size(); ++i) {
        weight_[i] = grid.mask[i] > 0.0F ? 1.0F / weight_[i] : 0.0F;
    }
}

std::vector<float> MaskedBlur::operator()(const std::vector<float>& values) const {
    std::vector<float> result = sums(values);
    for (std::size_t i = 0; i < result.size(); ++i) result[i] *= weight_[i];
    return result;
}

std::vector<float> MaskedBlur::sums(const std::vector<float>& values) const {
    const int reach = static_cast<int>(kernel_.size() / 2);
    const int width = grid_.width;
    const int height = grid_.height;
    const auto row = [&](auto& image, int r) {
        return image.data() + static_cast<std::ptrdiff_t>(r) * width;
    };
    std::vector<float> along_rows(values.size(), 0.0F);
    std::vector<float> both(values.size(), 0.0F);
    for (int r = 0; r < height; ++r) {
        const float* in = row(values, r);
        float* out = row(along_rows, r);
        for (int k = -reach; k <= reach; ++k) {
            const float weight = kernel_[static_cast<std::size_t>(k + reach)];
            const int last = std::min(width, width - k);
            for (int c = std::max(0, -k); c < last; ++c) out[c] += weight * in[c + k];
        }
    }
    for (int r = 0; r < height; ++r) {
        float* out = row(both, r);
        for (int k = std::max(-reach, -r); k <= std::min(reach, height - 1 - r); ++k) {
            const float weight = kernel_[static_cast<std::size_t>(k + reach)];
            const float* in = row(along_rows, r + k);
            for (int c = 0; c < width; ++c) out[c] += weight * in[c];
        }
    }
    return both;
}

}  // namespace gripscan
