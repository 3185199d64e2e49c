// Two exposures: noise alone is still, a small motion is seen if the texture allows, and the result
// says what could have been seen.
#include "core/stereo/stillness.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>

#include "core/base/seeded_random.h"

namespace gripscan {
namespace {

const cv::Rect kArea(20, 20, 280, 200);

/// Grain as on a sand-blasted part, as a sum of waves, so that it can be moved exactly.
class Grain {
  public:
    Grain(std::uint64_t seed, double contrast) : contrast_(contrast) {
        SeededRandom random(seed);
        for (Wave& wave : waves_) {
            const double length_px = random.uniform(5.0, 16.0);
            const double angle = random.uniform(0.0, 2.0 * std::numbers::pi);
            wave.kx = 2.0 * std::numbers::pi / length_px * std::cos(angle);
            wave.ky = 2.0 * std::numbers::pi / length_px * std::sin(angle);
            wave.phase = random.uniform(0.0, 2.0 * std::numbers::pi);
        }
    }
    [[nodiscard]] double at(double x, double y) const {
        double sum = 0.0;
        for (const Wave& w : waves_) sum += std::cos(w.kx * x + w.ky * y + w.phase);
        return contrast_ * sum * std::sqrt(2.0 / static_cast<double>(waves_.size()));
    }

  private:
    struct Wave {
        double kx = 0.0, ky = 0.0, phase = 0.0;
    };
    std::array<Wave, 24> waves_;
    double contrast_;
};

Grain surface(std::uint64_t seed, double contrast) {
    return {seed, contrast};
}

/// With sensor noise of 2 levels.
cv::Mat exposed(const Grain& grain, double dy_px, std::uint64_t seed, double offset = 0.0) {
    SeededRandom random(seed);
    cv::Mat1b image(260, 340);
    for (int y = 0; y < image.rows; ++y) {
        for (int x = 0; x < image.cols; ++x) {
            image(y, x) = cv::saturate_cast<uchar>(110.0 + offset + grain.at(x, y - dy_px) +
                                                   2.0 * random.normal());
        }
    }
    return image;
}

TEST(Stillness, NoiseAloneIsStill) {
    for (std::uint64_t seed = 1; seed <= 10; ++seed) {
        const Grain part = surface(seed, 14.0);
        const auto result =
            stillness(exposed(part, 0.0, 100 + seed), exposed(part, 0.0, 200 + seed), kArea);
        ASSERT_TRUE(result);
        EXPECT_TRUE(result->still())
            << "seed " << seed << ": " << result->motion_px << " of " << result->least_seen_px;
        // 2 levels and rounding to whole ones; the estimate assumes coarse texture.
        EXPECT_NEAR(result->noise_levels, 2.0, 0.5);
        EXPECT_GT(result->blocks, 50);
        EXPECT_LT(result->least_seen_px, 0.03);
    }
}

/// The surface 60 mm beside the axis of a part 0.74 m before a lens of 985 px moves by 0.028 px
/// when the joint still swings by 0.02 degrees.
TEST(Stillness, SeesTheLastSwingOfTheJoint) {
    int seen = 0;
    for (std::uint64_t seed = 1; seed <= 10; ++seed) {
        const Grain part = surface(seed, 14.0);
        const auto result =
            stillness(exposed(part, 0.0, 100 + seed), exposed(part, 0.028, 200 + seed), kArea);
        ASSERT_TRUE(result);
        if (!result->still()) ++seen;
    }
    EXPECT_GE(seen, 9);
}

TEST(Stillness, MeasuresALargerMotion) {
    const Grain part = surface(3, 14.0);
    for (const double moved_px : {0.1, 0.3}) {
        const auto result = stillness(exposed(part, 0.0, 1), exposed(part, moved_px, 2), kArea);
        ASSERT_TRUE(result);
        EXPECT_NEAR(result->motion_px, moved_px, 0.15 * moved_px);
    }
}

TEST(Stillness, AChangeOfLightIsNoMotion) {
    const Grain part = surface(4, 14.0);
    const auto result = stillness(exposed(part, 0.0, 1), exposed(part, 0.0, 2, 3.0), kArea);
    ASSERT_TRUE(result);
    EXPECT_TRUE(result->still()) << result->motion_px;
}

TEST(Stillness, LessTextureSeesLess) {
    const Grain rough = surface(5, 14.0);
    const Grain smooth = surface(5, 5.0);
    const auto well = stillness(exposed(rough, 0.0, 1), exposed(rough, 0.0, 2), kArea);
    const auto badly = stillness(exposed(smooth, 0.0, 1), exposed(smooth, 0.0, 2), kArea);
    ASSERT_TRUE(well && badly);
    EXPECT_GT(badly->least_seen_px, 2.0 * well->least_seen_px);
}

TEST(Stillness, SaysNothingWithoutTexture) {
    const Grain plain = surface(6, 1e-3);
    EXPECT_FALSE(stillness(exposed(plain, 0.0, 1), exposed(plain, 0.0, 2), kArea));
    const cv::Mat image = exposed(surface(1, 14.0), 0.0, 1);
    EXPECT_FALSE(stillness(image, image(cv::Rect(0, 0, 100, 100)), kArea));
    EXPECT_FALSE(stillness(image, image, cv::Rect(1000, 0, 50, 50)));
}

}  // namespace
}  // namespace gripscan
