// Known pairs: rows shifted by a known part of a pixel, a surface that half of the right image
// lacks.
#include "app/workstation/pair_measure.h"

#include <gmock/gmock.h>

#include <array>
#include <cmath>
#include <numbers>
#include <opencv2/core.hpp>

namespace gripscan::app {
namespace {

constexpr int kWidth = 480;
constexpr int kHeight = 320;
constexpr double kDisparity_px = 48.0;

RectifiedRig rig() {
    RectifiedRig rig;
    rig.image = {kWidth, kHeight};
    rig.f_px = 600.0;
    rig.cx_left_px = rig.cx_right_px = 239.5;
    rig.cy_px = 159.5;
    rig.baseline_m = 0.1;
    return rig;
}

/// A random texture that is known between its pixels too: waves of 5 to 20 px.
class Texture {
  public:
    explicit Texture(std::uint64_t seed) {
        cv::RNG random(seed);
        for (Wave& wave : waves_) {
            const double length_px = random.uniform(5.0, 20.0);
            const double way_rad = random.uniform(0.0, std::numbers::pi);
            wave = {std::cos(way_rad) / length_px, std::sin(way_rad) / length_px,
                    random.uniform(0.0, 1.0)};
        }
    }
    /// As an image whose first pixel lies at (x, y).
    [[nodiscard]] cv::Mat seen_from(double x, double y) const {
        cv::Mat grey(kHeight, kWidth, CV_8U);
        for (int v = 0; v < kHeight; ++v) {
            for (int u = 0; u < kWidth; ++u) {
                grey.at<uchar>(v, u) = cv::saturate_cast<uchar>(level_at(u + x, v + y));
            }
        }
        return grey;
    }

  private:
    struct Wave {
        double fx = 0.0, fy = 0.0, phase = 0.0;
    };
    [[nodiscard]] double level_at(double x, double y) const {
        double sum = 128.0;
        for (const Wave& wave : waves_) {
            constexpr double kAmplitude = 12.0;
            sum += kAmplitude *
                   std::sin(2.0 * std::numbers::pi * (wave.fx * x + wave.fy * y + wave.phase));
        }
        return sum;
    }
    std::array<Wave, 24> waves_;
};

/// A wall whose rows lie so much lower in the right image.
ui::StereoPicture wall(double rows_px) {
    const Texture surface(3);
    ui::StereoPicture pair;
    pair.left = surface.seen_from(0.0, 0.0);
    pair.right = surface.seen_from(kDisparity_px, -rows_px);
    return pair;
}

TEST(MeasurePair, FindsTheRowErrorOfARigThatIsOffBy13TenthsOfAPixel) {
    const auto measured = measure_pair(wall(1.3), rig(), std::nullopt, {});
    ASSERT_TRUE(measured) << measured.error().message;
    const ui::PairFacts& facts = measured->facts;
    ASSERT_TRUE(facts.row_error_px) << facts.why_no_row_error;
    EXPECT_GT(facts.row_error_sd_px, 0.0);
    EXPECT_NEAR(*facts.row_error_px, 1.3, std::max(0.02, 3.0 * facts.row_error_sd_px));
}

TEST(MeasurePair, FindsNoRowErrorWhereThereIsNone) {
    const auto measured = measure_pair(wall(0.0), rig(), std::nullopt, {});
    ASSERT_TRUE(measured) << measured.error().message;
    ASSERT_TRUE(measured->facts.row_error_px);
    EXPECT_NEAR(*measured->facts.row_error_px, 0.0, 0.02);
}

TEST(MeasurePair, FillIsTheShareOfTheAreaThatHasADepth) {
    // An area that both images show wholly: it ends where the disparity leaves the right image.
    const double z_m = rig().f_px * rig().baseline_m / kDisparity_px;
    const Box area{{-0.25, -0.25, z_m - 0.15}, {0.35, 0.25, z_m + 0.15}};
    ui::StereoPicture pair = wall(0.0);
    const auto whole = measure_pair(pair, rig(), area, {});
    ASSERT_TRUE(whole && whole->facts.fill);
    EXPECT_GT(*whole->facts.fill, 0.95);
    // The lower half of the right image shows something else.
    const cv::Mat other = Texture(4).seen_from(0.0, 0.0);
    const cv::Rect lower(0, kHeight / 2, kWidth, kHeight / 2);
    other(lower).copyTo(pair.right(lower));
    const auto half = measure_pair(pair, rig(), area, {});
    ASSERT_TRUE(half && half->facts.fill);
    EXPECT_NEAR(*half->facts.fill, 0.5 * *whole->facts.fill, 0.05);
}

TEST(MeasurePair, DisparityHasThePixelsAndTheUnitOfTheImages) {
    const auto measured = measure_pair(wall(0.0), rig(), std::nullopt, {});
    ASSERT_TRUE(measured);
    const cv::Mat& disparity = measured->picture->disparity;
    ASSERT_EQ(disparity.size(), cv::Size(kWidth, kHeight));
    EXPECT_NEAR(disparity.at<float>(kHeight / 2, 300), kDisparity_px, 0.25);
}

TEST(MeasurePair, SaysWhyThereIsNoNumber) {
    ui::StereoPicture blank;
    blank.left = cv::Mat(kHeight, kWidth, CV_8U, cv::Scalar(90));
    blank.right = blank.left.clone();
    const auto measured = measure_pair(blank, rig(), std::nullopt, {});
    ASSERT_TRUE(measured);
    EXPECT_FALSE(measured->facts.row_error_px);
    EXPECT_THAT(measured->facts.why_no_row_error, testing::HasSubstr("too little texture"));
}

TEST(MeasurePair, EndsWhenItIsGivenUp) {
    std::stop_source stop;
    stop.request_stop();
    const auto measured = measure_pair(wall(0.0), rig(), std::nullopt, stop.get_token());
    ASSERT_FALSE(measured);
    EXPECT_EQ(measured.error().kind, ErrorKind::kCancelled);
}

}  // namespace
}  // namespace gripscan::app
