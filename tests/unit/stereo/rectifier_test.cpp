#include "core/stereo/rectifier.h"

#include <gmock/gmock.h>

#include <cmath>
#include <opencv2/core.hpp>

#include "core/base/seeded_random.h"
#include "tests/unit/stereo/board_images.h"
#include "tests/unit/stereo/ray_scene.h"

namespace gripscan::test {
namespace {

using testing::HasSubstr;

StereoRig ideal_rig() {
    StereoRig rig;
    rig.image = {320, 240};
    rig.K_left << 400.0, 0.0, 150.0, 0.0, 400.0, 119.5, 0.0, 0.0, 1.0;
    rig.K_right = rig.K_left;
    rig.K_right(0, 2) = 170.0;
    rig.D_left = rig.D_right = {0.0, 0.0, 0.0, 0.0, 0.0};
    rig.T_right_left.translation() = Eigen::Vector3d(-0.1, 0.0, 0.0);
    return rig;
}

StereoFrame noise_frame(ImageSize size) {
    SeededRandom random(5);
    cv::Mat1b left(size.height, size.width);
    for (uchar& grey : left) grey = static_cast<uchar>(random.uniform(0.0, 256.0));
    return {left, left.clone(), 1.5};
}

TEST(Rectifier, LeavesARectifiedRigUntouched) {
    const StereoRig rig = ideal_rig();
    const auto rectifier = Rectifier::create(rig);
    ASSERT_TRUE(rectifier) << rectifier.error().message;
    const StereoFrame frame = noise_frame(rig.image);
    const auto out = rectifier->rectify(frame);
    ASSERT_TRUE(out);
    EXPECT_EQ(cv::norm(out->left, frame.left, cv::NORM_INF), 0.0);
    EXPECT_EQ(cv::norm(out->right, frame.right, cv::NORM_INF), 0.0);
    EXPECT_EQ(out->t_s, 1.5);
    EXPECT_TRUE(rectifier->R_rectified_left().isIdentity());
    // Different c_x are kept: Z = f·B/(d + c_x,right − c_x,left).
    EXPECT_DOUBLE_EQ(rectifier->rig().depth_m(20.0), 400.0 * 0.1 / 40.0);
}

/// Where a rectified pixel looks must be where the map has taken its grey value from: a smooth
/// picture painted on the sensor by the forward model (with distortion) must come back by the
/// rectified one.
TEST(Rectifier, BringsRaysOfADistortedRigToTheirPixels) {
    const StereoRig rig = distorted_rig();
    const auto rectifier = Rectifier::create(rig);
    ASSERT_TRUE(rectifier) << rectifier.error().message;
    const RectifiedRig& out = rectifier->rig();
    EXPECT_NEAR(out.baseline_m, rig.baseline_m(), 1e-9);
    EXPECT_EQ(out.cx_left_px, out.cx_right_px);
    // In the camera frame the right camera lies on the x axis: R1 turns its direction there.
    const Eigen::Vector3d right_centre =
        -(rig.T_right_left.linear().transpose() * rig.T_right_left.translation());
    const Eigen::Vector3d turned = rectifier->R_rectified_left() * right_centre;
    EXPECT_NEAR(turned.x(), rig.baseline_m(), 1e-9);
    EXPECT_NEAR(turned.tail<2>().norm(), 0.0, 1e-9);

    const auto pattern = [](double x, double y) {
        return 128.0 + 50.0 * std::sin(60.0 * x) + 50.0 * std::cos(45.0 * y + 20.0 * x);
    };
    const auto& k = rig.D_left;
    // Grey value of a sensor pixel from its undistorted direction, found by fixed-point iteration.
    cv::Mat1b sensor(rig.image.height, rig.image.width);
    for (int v = 0; v < sensor.rows; ++v) {
        for (int u = 0; u < sensor.cols; ++u) {
            const double xd = (u - rig.K_left(0, 2)) / rig.K_left(0, 0);
            const double yd = (v - rig.K_left(1, 2)) / rig.K_left(1, 1);
            double x = xd, y = yd;
            for (int i = 0; i < 30; ++i) {
                const double r2 = x * x + y * y;
                const double factor = 1.0 + k[0] * r2 + k[1] * r2 * r2;
                x = xd / factor;
                y = yd / factor;
            }
            sensor(v, u) = cv::saturate_cast<uchar>(pattern(x, y));
        }
    }
    const auto frame = rectifier->rectify({sensor, sensor.clone(), 0.0});
    ASSERT_TRUE(frame) << frame.error().message;
    double worst = 0.0;
    for (int v = 30; v < out.image.height - 30; v += 3) {
        for (int u = 30; u < out.image.width - 30; u += 3) {
            const Eigen::Vector3d in_left =
                rectifier->R_rectified_left().transpose() *
                Eigen::Vector3d((u - out.cx_left_px) / out.f_px, (v - out.cy_px) / out.f_px, 1.0);
            const double expected = pattern(in_left.x() / in_left.z(), in_left.y() / in_left.z());
            worst = std::max(worst, std::abs(frame->left.at<uchar>(v, u) - expected));
        }
    }
    // Two roundings to whole levels (0.5 each, the first spread by the interpolation); a shift of
    // 1/32 px, what OpenCV's remap rounds to, would already make 0.2 more.
    EXPECT_LT(worst, 1.3);
}

TEST(Rectifier, NamesImagesThatDoNotFit) {
    const StereoRig rig = ideal_rig();
    const auto rectifier = Rectifier::create(rig);
    ASSERT_TRUE(rectifier);
    StereoFrame frame = noise_frame(rig.image);
    frame.right = noise_frame({160, 120}).right;
    const auto small = rectifier->rectify(frame);
    ASSERT_FALSE(small);
    EXPECT_THAT(small.error().message, HasSubstr("right image is 160 x 120"));
    frame.right = cv::Mat();
    EXPECT_FALSE(rectifier->rectify(frame));
    frame.right = cv::Mat(240, 320, CV_8UC3, cv::Scalar(1, 2, 3));
    EXPECT_THAT(rectifier->rectify(frame).error().message, HasSubstr("grey"));
}

TEST(Rectifier, RefusesARigThatIsNone) {
    StereoRig rig = ideal_rig();
    rig.T_right_left.translation().x() = 0.1;
    const auto rectifier = Rectifier::create(rig);
    ASSERT_FALSE(rectifier);
    EXPECT_THAT(rectifier.error().message, HasSubstr("wrong sign"));
}

}  // namespace
}  // namespace gripscan::test
