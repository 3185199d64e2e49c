#include "core/sim/texture.h"

#include <gtest/gtest.h>

#include "core/base/seeded_random.h"

namespace gripscan::sim {
namespace {

struct Moments {
    double mean = 0.0;
    double sigma = 0.0;
};

template <typename Function>
Moments moments(const Function& value_at) {
    SeededRandom random(11);
    constexpr int kSamples = 200000;
    double sum = 0.0;
    double sum2 = 0.0;
    for (int i = 0; i < kSamples; ++i) {
        const Eigen::Vector3f p(static_cast<float>(random.uniform(-50, 50)),
                                static_cast<float>(random.uniform(-50, 50)),
                                static_cast<float>(random.uniform(-50, 50)));
        const double value = value_at(p);
        sum += value;
        sum2 += value * value;
    }
    const double mean = sum / kSamples;
    return {mean, std::sqrt(sum2 / kSamples - mean * mean)};
}

TEST(Texture, OneOctaveHasTheStatedStandardDeviation) {
    const Moments m = moments([](const Eigen::Vector3f& p) { return gradient_noise(p, 3); });
    // A million cells, a fifth of them sampled: 0.26/√200000 = 0.0006.
    EXPECT_NEAR(m.mean, 0.0, 0.003);
    EXPECT_NEAR(m.sigma, kNoiseSigma, 0.003);
}

TEST(Texture, AllOctavesTogetherHaveTheContrastAskedFor) {
    const Texture texture{.cell_m = 0.5, .octaves = 4, .gain = 1.25, .contrast = 0.12, .seed = 8};
    const TextureField field(texture);
    const Moments m = moments([&](const Eigen::Vector3f& p) { return field.factor(p); });
    EXPECT_NEAR(m.mean, 1.0, 0.002);
    EXPECT_NEAR(m.sigma, 0.12, 0.003);
}

TEST(Texture, IsSmoothWithinACellAndNewBeyondIt) {
    // Correlation of neighbours: near 1 at a tenth of a cell, none at three cells.
    SeededRandom random(2);
    double close = 0.0;
    double far = 0.0;
    constexpr int kSamples = 50000;
    for (int i = 0; i < kSamples; ++i) {
        const Eigen::Vector3f p(static_cast<float>(random.uniform(-50, 50)),
                                static_cast<float>(random.uniform(-50, 50)),
                                static_cast<float>(random.uniform(-50, 50)));
        const double here = gradient_noise(p, 1);
        close += here * gradient_noise(p + Eigen::Vector3f(0.1F, 0, 0), 1);
        far += here * gradient_noise(p + Eigen::Vector3f(3.0F, 0, 0), 1);
    }
    const double variance = kNoiseSigma * kNoiseSigma * kSamples;
    EXPECT_GT(close / variance, 0.9);
    EXPECT_LT(std::abs(far / variance), 0.03);
}

}  // namespace
}  // namespace gripscan::sim
