#include "core/stereo/rectifier.h"

#include <algorithm>
#include <cmath>
#include <opencv2/calib3d.hpp>
#include <opencv2/core.hpp>
#include <opencv2/core/eigen.hpp>

#include "core/stereo/cubic_spline.h"

namespace gripscan {
namespace {

constexpr int kPad = 4;  ///< mirrored pixels around the spline, more than its taps reach

/// One image through its map of source positions (CV_32FC1 each); black where the map leaves the
/// sensor.
cv::Mat resample(const cv::Mat& grey, const cv::Mat& map_x, const cv::Mat& map_y) {
    const cv::Mat c = image_spline(grey, kPad, for_each_in_order);
    const float max_x = static_cast<float>(grey.cols - 1);
    const float max_y = static_cast<float>(grey.rows - 1);
    cv::Mat out = cv::Mat::zeros(grey.size(), CV_8U);
    for (int y = 0; y < out.rows; ++y) {
        const auto* px = map_x.ptr<float>(y);
        const auto* py = map_y.ptr<float>(y);
        auto* to = out.ptr<uchar>(y);
        for (int x = 0; x < out.cols; ++x) {
            const float sx = px[x];
            const float sy = py[x];
            if (!(sx >= 0.0F && sx <= max_x && sy >= 0.0F && sy <= max_y)) continue;
            const int ix = static_cast<int>(sx);
            const int iy = static_cast<int>(sy);
            const SplineTaps u(sx - static_cast<float>(ix));
            const SplineTaps v(sy - static_cast<float>(iy));
            const float weights[4] = {v.w0, v.w1, v.w2, v.w3};
            float value = 0.0F;
            for (int k = 0; k < 4; ++k) {
                const auto* s = c.ptr<float>(iy + kPad - 1 + k) + ix + kPad - 1;
                value += weights[k] * (u.w0 * s[0] + u.w1 * s[1] + u.w2 * s[2] + u.w3 * s[3]);
            }
            to[x] = static_cast<uchar>(std::clamp(value + 0.5F, 0.0F, 255.0F));
        }
    }
    return out;
}

Status check_image(const cv::Mat& image, ImageSize size, const char* which) {
    if (image.empty()) return input_error("the {} image is empty", which);
    if (image.type() != CV_8UC1) {
        return input_error("the {} image must be 8-bit grey; convert it first", which);
    }
    if (image.cols != size.width || image.rows != size.height) {
        return input_error(
            "the {} image is {} x {} px, the rig says {} x {}; use the rig of this "
            "camera and resolution",
            which, image.cols, image.rows, size.width, size.height);
    }
    return {};
}

}  // namespace

struct Rectifier::Maps {
    RectifiedRig rig;
    Eigen::Matrix3d R_rectified_left = Eigen::Matrix3d::Identity();
    bool untouched = true;
    cv::Mat left_x, left_y, right_x, right_y;

    void take_over(const StereoRig& from);  ///< of a rig that is rectified already
    void compute(const StereoRig& from);
};

Rectifier::Rectifier(std::unique_ptr<Maps> maps) : maps_(std::move(maps)) {}
Rectifier::Rectifier(Rectifier&&) noexcept = default;
Rectifier& Rectifier::operator=(Rectifier&&) noexcept = default;
Rectifier::~Rectifier() = default;

void Rectifier::Maps::take_over(const StereoRig& from) {
    rig.f_px = from.K_left(0, 0);
    rig.cx_left_px = from.K_left(0, 2);
    rig.cx_right_px = from.K_right(0, 2);
    rig.cy_px = from.K_left(1, 2);
    rig.baseline_m = from.baseline_m();
}

void Rectifier::Maps::compute(const StereoRig& from) {
    untouched = false;
    cv::Mat K1, K2, R, T, R1, R2, P1, P2, Q;
    cv::eigen2cv(from.K_left, K1);
    cv::eigen2cv(from.K_right, K2);
    cv::eigen2cv(Eigen::Matrix3d(from.T_right_left.linear()), R);
    cv::eigen2cv(Eigen::Vector3d(from.T_right_left.translation()), T);
    const cv::Mat D1(from.D_left, true);
    const cv::Mat D2(from.D_right, true);
    const cv::Size size(from.image.width, from.image.height);
    cv::stereoRectify(K1, D1, K2, D2, size, R, T, R1, R2, P1, P2, Q, cv::CALIB_ZERO_DISPARITY, -1);
    cv::initUndistortRectifyMap(K1, D1, R1, P1, size, CV_32FC1, left_x, left_y);
    cv::initUndistortRectifyMap(K2, D2, R2, P2, size, CV_32FC1, right_x, right_y);
    rig.f_px = P1.at<double>(0, 0);
    rig.cx_left_px = P1.at<double>(0, 2);
    rig.cx_right_px = P2.at<double>(0, 2);
    rig.cy_px = P1.at<double>(1, 2);
    rig.baseline_m = -P2.at<double>(0, 3) / P2.at<double>(0, 0);
    cv::cv2eigen(R1, R_rectified_left);
}

Result<Rectifier> Rectifier::create(const StereoRig& rig) {
    if (const Status status = validate(rig); !status) return forward_error(status.error());
    auto maps = std::make_unique<Maps>();
    maps->rig.image = rig.image;
    if (rig.is_rectified()) {
        maps->take_over(rig);
        return Rectifier(std::move(maps));
    }
    try {
        maps->compute(rig);
    } catch (const cv::Exception& e) {
        return input_error("the rig cannot be rectified: {}", e.err);
    }
    if (!(maps->rig.f_px > 0.0) || !(maps->rig.baseline_m > 0.0) ||
        !maps->R_rectified_left.allFinite()) {
        return input_error("the rig cannot be rectified: focal length {} px, baseline {} m",
                           maps->rig.f_px, maps->rig.baseline_m);
    }
    return Rectifier(std::move(maps));
}

const RectifiedRig& Rectifier::rig() const {
    return maps_->rig;
}
const Eigen::Matrix3d& Rectifier::R_rectified_left() const {
    return maps_->R_rectified_left;
}

Result<StereoFrame> Rectifier::rectify(const StereoFrame& frame) const {
    if (Status s = check_image(frame.left, maps_->rig.image, "left"); !s)
        return forward_error(s.error());
    if (Status s = check_image(frame.right, maps_->rig.image, "right"); !s)
        return forward_error(s.error());
    if (maps_->untouched) return frame;
    return StereoFrame{resample(frame.left, maps_->left_x, maps_->left_y),
                       resample(frame.right, maps_->right_x, maps_->right_y), frame.t_s};
}

}  // namespace gripscan
