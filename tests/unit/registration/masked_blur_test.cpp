// Smoothing with holes: against the plain sum, narrow and wide.
#include "core/registration/masked_blur.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/base/seeded_random.h"

namespace gripscan {
namespace {

MaskedGrid grid_with_holes(int width, int height, double share, std::uint64_t seed) {
    SeededRandom random(seed);
    MaskedGrid grid{width, height, {}};
    for (int i = 0; i < width * height; ++i) {
        grid.mask.push_back(random.uniform() < share ? 1.0F : 0.0F);
    }
    return grid;
}

std::vector<float> masked_values(const MaskedGrid& grid, std::uint64_t seed) {
    SeededRandom random(seed);
    std::vector<float> values;
    for (const float m : grid.mask) values.push_back(m * static_cast<float>(random.uniform(0, 99)));
    return values;
}

TEST(MaskedBlur, NarrowOnesAreTheGaussianMean) {
    for (const float sigma : {0.6F, 1.6F}) {
        const MaskedGrid grid = grid_with_holes(23, 17, 0.7, 1);
        const auto values = masked_values(grid, 2);
        const auto blurred = MaskedBlur(grid, sigma)(values);
        const int reach = std::max(1, static_cast<int>(std::lround(2.2F * sigma)));
        for (int r = 0; r < grid.height; ++r) {
            for (int c = 0; c < grid.width; ++c) {
                double sum = 0.0;
                double weights = 0.0;
                for (int y = std::max(0, r - reach); y <= std::min(grid.height - 1, r + reach);
                     ++y) {
                    for (int x = std::max(0, c - reach); x <= std::min(grid.width - 1, c + reach);
                         ++x) {
                        const auto j = static_cast<std::size_t>(y * grid.width + x);
                        const double d2 = (x - c) * (x - c) + (y - r) * (y - r);
                        const double w = grid.mask[j] * std::exp(-0.5 * d2 / (sigma * sigma));
                        sum += w * values[j];
                        weights += w;
                    }
                }
                const auto i = static_cast<std::size_t>(r * grid.width + c);
                EXPECT_NEAR(blurred[i], grid.mask[i] > 0.0F ? sum / weights : 0.0, 1e-3);
            }
        }
    }
}

TEST(MaskedBlur, AConstantStaysConstantWhateverTheHoles) {
    for (const float sigma : {0.6F, 1.6F, 3.2F, 9.0F}) {
        for (const double share : {0.05, 0.5, 1.0}) {
            const MaskedGrid grid = grid_with_holes(41, 29, share, 3);
            std::vector<float> values;
            for (const float m : grid.mask) values.push_back(100.0F * m);
            const auto blurred = MaskedBlur(grid, sigma)(values);
            for (std::size_t i = 0; i < blurred.size(); ++i) {
                EXPECT_NEAR(blurred[i], values[i], 0.01F);
            }
        }
    }
}

TEST(MaskedBlur, WideOnesSpreadAsFarAsTheirGaussian) {
    for (const float sigma : {2.0F, 3.2F, 4.0F, 6.0F, 9.0F}) {
        MaskedGrid grid{121, 121, std::vector<float>(121 * 121, 1.0F)};
        std::vector<float> spike(grid.mask.size(), 0.0F);
        spike[60 * 121 + 60] = 1000.0F;
        const auto blurred = MaskedBlur(grid, sigma)(spike);
        double sum = 0.0;
        double rows = 0.0;
        double columns = 0.0;
        for (int r = 0; r < 121; ++r) {
            for (int c = 0; c < 121; ++c) {
                const double v = blurred[static_cast<std::size_t>(r * 121 + c)];
                sum += v;
                rows += v * (r - 60) * (r - 60);
                columns += v * (c - 60) * (c - 60);
            }
        }
        EXPECT_NEAR(sum, 1000.0, 2.0);
        // Boxes have whole widths: their deviation is right to half a pixel.
        EXPECT_NEAR(std::sqrt(rows / sum), sigma, 0.5);
        EXPECT_NEAR(std::sqrt(columns / sum), std::sqrt(rows / sum), 1e-3);
    }
}

TEST(MaskedBlur, WindowsWiderThanTheGridAreNoHarm) {
    const MaskedGrid grid = grid_with_holes(3, 2, 1.0, 1);
    for (const float value : MaskedBlur(grid, 9.0F)({1, 2, 3, 4, 5, 6})) {
        EXPECT_TRUE(std::isfinite(value));
        EXPECT_GE(value, 1.0F);
        EXPECT_LE(value, 6.0F);
    }
}

}  // namespace
}  // namespace gripscan
