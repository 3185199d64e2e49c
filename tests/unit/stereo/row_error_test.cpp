// Row errors that are known, because the right camera is rendered with its rows shifted.
#include "core/stereo/row_error.h"

#include <gmock/gmock.h>

#include <opencv2/core.hpp>

#include "tests/unit/stereo/ray_scene.h"

namespace gripscan::test {
namespace {

using testing::HasSubstr;

constexpr int kWidth = 480;
constexpr int kHeight = 300;

/// A ball in front of a wall, seen by cameras whose rows lie so much lower in the image.
StereoFrame seen(double rows_px, const CameraNoise& noise = {}) {
    RayScene scene;
    scene.planes.push_back({Eigen::Vector3d(0.1, 0.05, 1.0).normalized(), 1.25});
    scene.spheres.push_back({Eigen::Vector3d(0.01, 0.0, 0.74), 0.06});
    RectifiedRig rig = cell_rig(kWidth, kHeight);
    rig.cy_px += rows_px;
    return render(scene, rig, noise).frame;
}

/// The left camera as it should be, the right one off by so many rows.
StereoFrame pair_with_offset(double rows_px, const CameraNoise& noise = {}) {
    static const StereoFrame straight = seen(0.0);
    return {straight.left, seen(rows_px, noise).right, 0.0};
}

SearchArea whole_image() {
    return {cv::Rect(0, 0, kWidth, kHeight), 64, 128};
}

class KnownRowError : public testing::TestWithParam<double> {};

TEST_P(KnownRowError, IsFoundWithinItsNoise) {
    const auto error = measure_row_error(pair_with_offset(GetParam()), whole_image(), {}, {});
    ASSERT_TRUE(error) << error.error().message;
    EXPECT_GT(error->features, 40);
    EXPECT_LT(error->sd_px, 0.02);
    EXPECT_NEAR(error->median_px, GetParam(), std::max(3.0 * error->sd_px, 0.02));
}
INSTANTIATE_TEST_SUITE_P(Rows, KnownRowError, testing::Values(0.0, 0.3, 1.3, -1.3, -4.6));

TEST(RowErrors, DoNotDependOnTheBrightnessOfTheCameras) {
    CameraNoise noise;
    noise.right_gain = 0.8;
    noise.right_offset = 12.0;
    const auto error = measure_row_error(pair_with_offset(1.3, noise), whole_image(), {}, {});
    ASSERT_TRUE(error) << error.error().message;
    EXPECT_NEAR(error->median_px, 1.3, 0.03);
}

TEST(RowErrors, BeyondTheBandAreNoNumber) {
    const auto error = measure_row_error(pair_with_offset(11.0), whole_image(), {}, {});
    ASSERT_FALSE(error);
    EXPECT_THAT(error.error().message, HasSubstr("found in the right image within 6 rows"));
}

TEST(RowErrors, OfNoiseAloneAreNoNumber) {
    StereoFrame frame;
    frame.left.create(kHeight, kWidth, CV_8U);
    frame.right.create(kHeight, kWidth, CV_8U);
    cv::RNG random(7);
    random.fill(frame.left, cv::RNG::NORMAL, 120.0, 2.0);
    random.fill(frame.right, cv::RNG::NORMAL, 120.0, 2.0);
    const auto error = measure_row_error(frame, whole_image(), {}, {});
    ASSERT_FALSE(error);
    EXPECT_THAT(error.error().message, HasSubstr("too little texture"));
}

TEST(RowErrors, CanBeCancelled) {
    std::stop_source stop;
    stop.request_stop();
    const auto error =
        measure_row_error(pair_with_offset(0.0), whole_image(), {}, stop.get_token());
    ASSERT_FALSE(error);
    EXPECT_EQ(error.error().kind, ErrorKind::kCancelled);
}

}  // namespace
}  // namespace gripscan::test
