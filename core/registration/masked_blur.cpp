#include "core/registration/masked_blur.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace gripscan {
namespace {

/// From here on two boxes, whose cost does not grow with the window, stand for the Gaussian.
constexpr float kBoxFrom_px = 2.0F;

/// Sum over 2 · half + 1 neighbours of every value of a line, cut at its ends.
void box_sum(const float* in, float* out, int length, std::ptrdiff_t step, int half) {
    double sum = 0.0;
    for (int i = 0; i < std::min(half, length); ++i) sum += in[i * step];
    for (int i = 0; i < length; ++i) {
        if (i + half < length) sum += in[(i + half) * step];
        if (i > half) sum -= in[(i - half - 1) * step];
        out[i * step] = static_cast<float>(sum);
    }
}

}  // namespace

MaskedBlur::MaskedBlur(const MaskedGrid& grid, float sigma_px) : grid_(grid) {
    if (sigma_px >= kBoxFrom_px) {
        // Two boxes of width w have the variance (w² − 1)/6 of the Gaussian they stand for.
        half_box_ = std::max(1, static_cast<int>(std::lround(
                                    0.5F * (std::sqrt(6.0F * sigma_px * sigma_px + 1.0F) - 1.0F))));
        set_weights();
        return;
    }
    const int reach = std::max(1, static_cast<int>(std::lround(2.2F * sigma_px)));
    for (int k = -reach; k <= reach; ++k) {
        kernel_.push_back(std::exp(-0.5F * static_cast<float>(k * k) / (sigma_px * sigma_px)));
    }
    set_weights();
}

void MaskedBlur::set_weights() {
    weight_ = sums(grid_.mask);
    for (std::size_t i = 0; i < weight_.size(); ++i) {
        weight_[i] = grid_.mask[i] > 0.0F ? 1.0F / weight_[i] : 0.0F;
    }
}

std::vector<float> MaskedBlur::box_sums(std::vector<float> values) const {
    std::vector<float> other(values.size());
    for (int pass = 0; pass < 2; ++pass) {
        for (int r = 0; r < grid_.height; ++r) {
            const std::ptrdiff_t at = static_cast<std::ptrdiff_t>(r) * grid_.width;
            box_sum(values.data() + at, other.data() + at, grid_.width, 1, half_box_);
        }
        // Columns: row by row with one running sum a column, so that memory is read in order.
        std::vector<double> running(static_cast<std::size_t>(grid_.width), 0.0);
        const auto add_row = [&](int r, double sign) {
            const float* in = other.data() + static_cast<std::ptrdiff_t>(r) * grid_.width;
            for (std::size_t c = 0; c < running.size(); ++c) running[c] += sign * in[c];
        };
        for (int r = 0; r < std::min(half_box_, grid_.height); ++r) add_row(r, 1.0);
        for (int r = 0; r < grid_.height; ++r) {
            if (r + half_box_ < grid_.height) add_row(r + half_box_, 1.0);
            if (r > half_box_) add_row(r - half_box_ - 1, -1.0);
            float* out = values.data() + static_cast<std::ptrdiff_t>(r) * grid_.width;
            for (std::size_t c = 0; c < running.size(); ++c) {
                out[c] = static_cast<float>(running[c]);
            }
        }
    }
    return values;
}

std::vector<float> MaskedBlur::operator()(const std::vector<float>& values) const {
    std::vector<float> result = sums(values);
    for (std::size_t i = 0; i < result.size(); ++i) result[i] *= weight_[i];
    return result;
}

std::vector<float> MaskedBlur::sums(const std::vector<float>& values) const {
    if (half_box_ > 0) return box_sums(values);
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
