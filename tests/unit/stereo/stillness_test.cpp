// Two exposures: noise alone is still, a small motion is seen if the texture allows, and the result
// says what could have been seen.
#include "core/stereo/stillness.h"

#include <gtest/gtest.h>

#include <opencv2/imgproc.hpp>

#include "core/base/seeded_random.h"

namespace gripscan {
namespace {

const cv::Rect kArea(20, 20, 280, 200);

/// Grain as on a sand-blasted part: standard deviation `contrast`, some 3 px wide.
cv::Mat1f surface(std::uint64_t seed, double contrast) {
    SeededRandom random(seed);
    cv::Mat1f white(260, 340);
    for (float& value : white) value = static_cast<float>(random.normal());
    cv::Mat1f grain;
    cv::GaussianBlur(white, grain, {}, 1.5);
    cv::Scalar mean, deviation;
    cv::meanStdDev(grain, mean, deviation);
    const double scale = contrast / deviation[0];
    grain.convertTo(grain, CV_32F, scale, 110.0 - scale * mean[0]);
    return grain;
}

cv::Mat exposed(const cv::Mat1f& surface, double dy_px, std::uint64_t seed, double offset = 0.0) {
    // Shifted by whole and half pixels of an image eight times as fine.
    cv::Mat1f large, shifted, moved;
    cv::resize(surface, large, {}, 8, 8, cv::INTER_CUBIC);
    const cv::Matx23d L(1, 0, 0, 0, 1, 8 * dy_px);
    cv::warpAffine(large, shifted, L, large.size(), cv::INTER_CUBIC);
    cv::resize(shifted, moved, surface.size(), 0, 0, cv::INTER_AREA);
    SeededRandom random(seed);
    for (float& value : moved) {
        value += static_cast<float>(offset + 2.0 * random.normal());
    }
    cv::Mat image;
    moved.convertTo(image, CV_8U);
    return image;
}

TEST(Stillness, NoiseAloneIsStill) {
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
        const cv::Mat1f part = surface(seed, 14.0);
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
        const cv::Mat1f part = surface(seed, 14.0);
        const auto result =
            stillness(exposed(part, 0.0, 100 + seed), exposed(part, 0.028, 200 + seed), kArea);
        ASSERT_TRUE(result);
        if (!result->still()) ++seen;
    }
    EXPECT_GE(seen, 9);
}

TEST(Stillness, MeasuresALargerMotion) {
    const cv::Mat1f part = surface(3, 14.0);
    for (const double moved_px : {0.1, 0.3}) {
        const auto result = stillness(exposed(part, 0.0, 1), exposed(part, moved_px, 2), kArea);
        ASSERT_TRUE(result);
        EXPECT_NEAR(result->motion_px, moved_px, 0.15 * moved_px);
    }
}

TEST(Stillness, AChangeOfLightIsNoMotion) {
    const cv::Mat1f part = surface(4, 14.0);
    const auto result = stillness(exposed(part, 0.0, 1), exposed(part, 0.0, 2, 3.0), kArea);
    ASSERT_TRUE(result);
    EXPECT_TRUE(result->still()) << result->motion_px;
}

TEST(Stillness, LessTextureSeesLess) {
    const cv::Mat1f rough = surface(5, 14.0);
    const cv::Mat1f smooth = surface(5, 5.0);
    const auto well = stillness(exposed(rough, 0.0, 1), exposed(rough, 0.0, 2), kArea);
    const auto badly = stillness(exposed(smooth, 0.0, 1), exposed(smooth, 0.0, 2), kArea);
    ASSERT_TRUE(well && badly);
    EXPECT_GT(badly->least_seen_px, 2.0 * well->least_seen_px);
}

TEST(Stillness, SaysNothingWithoutTexture) {
    const cv::Mat1f plain = surface(6, 1e-3);
    EXPECT_FALSE(stillness(exposed(plain, 0.0, 1), exposed(plain, 0.0, 2), kArea));
    const cv::Mat image = exposed(surface(1, 14.0), 0.0, 1);
    EXPECT_FALSE(stillness(image, image(cv::Rect(0, 0, 100, 100)), kArea));
    EXPECT_FALSE(stillness(image, image, cv::Rect(1000, 0, 50, 50)));
}

}  // namespace
}  // namespace gripscan
