// The camera's motion is read from the background: found where there is one, not invented where
// there is only noise, not hidden by what moves on its own.
#include "core/stereo/background_shift.h"

#include <gtest/gtest.h>

#include <opencv2/imgproc.hpp>

#include "core/base/seeded_random.h"

namespace gripscan {
namespace {

constexpr int kWidth = 800;
constexpr int kHeight = 600;
const cv::Rect kArea(280, 200, 240, 200);

/// Smooth random structure from 4 to 20 px, larger than the image so that it can be shifted.
cv::Mat1f scene(std::uint64_t seed) {
    SeededRandom random(seed);
    cv::Mat1f white(kHeight + 200, kWidth + 200);
    for (float& value : white) value = static_cast<float>(random.normal());
    cv::Mat1f fine, coarse;
    cv::GaussianBlur(white, fine, {}, 2.0);
    cv::GaussianBlur(white, coarse, {}, 8.0);
    cv::Mat1f sum;
    cv::addWeighted(fine, 100.0, coarse, 250.0, 110.0, sum);
    return sum;
}

/// What the camera sees after the image has moved by `shift`, with sensor noise of its own.
cv::Mat seen(const cv::Mat1f& scene, cv::Point2d shift, std::uint64_t seed, double noise = 2.0,
             double gain = 1.0) {
    const cv::Matx23d M(1, 0, -100 + shift.x, 0, 1, -100 + shift.y);
    cv::Mat1f moved;
    cv::warpAffine(scene, moved, M, {kWidth, kHeight}, cv::INTER_CUBIC);
    SeededRandom random(seed);
    for (float& value : moved) {
        value = static_cast<float>(gain * static_cast<double>(value) + noise * random.normal());
    }
    cv::Mat image;
    moved.convertTo(image, CV_8U);
    return image;
}

std::optional<BackgroundShift> shift_between(const cv::Mat& a, const cv::Mat& b) {
    return background_shift(background_of(a, kArea), background_of(b, kArea));
}

TEST(BackgroundShift, StillCameraShowsHundredthsOfAPixel) {
    for (const std::uint64_t seed : {1U, 2U, 3U, 4U}) {
        const cv::Mat1f there = scene(seed);
        const auto shift =
            shift_between(seen(there, {0, 0}, 10 + seed), seen(there, {0, 0}, 20 + seed));
        ASSERT_TRUE(shift);
        EXPECT_LT(shift->shift_px, 0.1) << "median length of noise alone";
        EXPECT_GT(shift->patches, 50);
        EXPECT_GT(shift->agreeing, 0.95);
    }
}

/// 0.05 px is far below what any step notices.
TEST(BackgroundShift, TwentiethOfAPixelStaysSmall) {
    const cv::Mat1f there = scene(5);
    const auto shift = shift_between(seen(there, {0, 0}, 1), seen(there, {0.05, 0.0}, 2));
    ASSERT_TRUE(shift);
    EXPECT_LT(shift->shift_px, 0.15);
}

/// 4 mm or 0.4 degrees move the image of an ordinary lens by 5 to 8 px.
TEST(BackgroundShift, MeasuresABump) {
    const cv::Mat1f there = scene(6);
    for (const cv::Point2d moved : {cv::Point2d(6.9, 0.0), cv::Point2d(-3.0, 4.0),
                                    cv::Point2d(1.0, 0.0), cv::Point2d(-20.0, 12.0)}) {
        const auto shift = shift_between(seen(there, {0, 0}, 1), seen(there, moved, 2));
        ASSERT_TRUE(shift);
        // Half a halved pixel's parabola error.
        EXPECT_NEAR(shift->shift_px, std::hypot(moved.x, moved.y), 0.25);
        EXPECT_GT(shift->agreeing, 0.95);
    }
}

TEST(BackgroundShift, ExposureDoesNotMatter) {
    const cv::Mat1f there = scene(7);
    const auto shift = shift_between(seen(there, {0, 0}, 1), seen(there, {0, 0}, 2, 2.0, 0.7));
    ASSERT_TRUE(shift);
    EXPECT_LT(shift->shift_px, 0.1);
}

TEST(BackgroundShift, AMinorityThatMovesIsNoCamera) {
    const cv::Mat1f there = scene(8);
    const cv::Mat before = seen(there, {0, 0}, 1);
    cv::Mat now = seen(there, {0, 0}, 2);
    // A third of the image moves by 5 px.
    const cv::Rect part(0, 0, kWidth / 3, kHeight);
    seen(there, {5, 0}, 2)(part).copyTo(now(part));
    const auto shift = shift_between(before, now);
    ASSERT_TRUE(shift);
    EXPECT_LT(shift->shift_px, 0.2);
    EXPECT_LT(shift->agreeing, 0.9) << "but it is told";
}

TEST(BackgroundShift, TheRegistrationAreaDoesNotCount) {
    const cv::Mat1f there = scene(9);
    cv::Mat now = seen(there, {0, 0}, 2);
    seen(there, {9, 3}, 2)(kArea).copyTo(now(kArea));
    const auto shift = shift_between(seen(there, {0, 0}, 1), now);
    ASSERT_TRUE(shift);
    EXPECT_LT(shift->shift_px, 0.1);
    EXPECT_GT(shift->agreeing, 0.95);
}

TEST(BackgroundShift, SaysNothingWithoutABackground) {
    const cv::Mat1f plain(kHeight + 200, kWidth + 200, 120.0F);
    EXPECT_FALSE(shift_between(seen(plain, {0, 0}, 1), seen(plain, {0, 0}, 2)));
    const cv::Mat1f there = scene(1);
    const cv::Mat image = seen(there, {0, 0}, 1);
    const Background all = background_of(image, {0, 0, kWidth, kHeight});
    EXPECT_FALSE(background_shift(all, all)) << "the registration area fills the image";
    EXPECT_FALSE(background_shift(background_of(image, kArea),
                                  background_of(image(cv::Rect(0, 0, 400, 300)), {})))
        << "images of another size";
    EXPECT_FALSE(background_shift({}, {}));
}

}  // namespace
}  // namespace gripscan
