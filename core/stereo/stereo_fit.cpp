#include "core/stereo/stereo_fit.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <opencv2/calib3d.hpp>
#include <opencv2/core/eigen.hpp>

#include "core/base/units.h"

namespace gripscan {
namespace {

struct Model {
    const char* name;
    int flags;
    int parameters;  ///< of one camera
};

constexpr std::array kModels{
    Model{"two radial terms", cv::CALIB_ZERO_TANGENT_DIST | cv::CALIB_FIX_K3, 6},
    Model{"two radial and two tangential terms", cv::CALIB_FIX_K3, 8},
    Model{"three radial and two tangential terms", 0, 9},
};

/// Corners of a board err together (print, bending, light), so they count as fewer.
constexpr double kCornersPerObservation = 4.0;

using Points2 = std::vector<std::vector<cv::Point2f>>;
using Points3 = std::vector<std::vector<cv::Point3f>>;

struct Camera {
    cv::Mat K, D;
    double rms_px = 0.0;
    std::vector<cv::Mat> rotations;
};

Camera fit_camera(const Points3& board, const Points2& corners, cv::Size size, int flags) {
    Camera camera;
    std::vector<cv::Mat> shifts;
    camera.rms_px =
        cv::calibrateCamera(board, corners, size, camera.K, camera.D, camera.rotations, shifts,
                            flags, {cv::TermCriteria::COUNT + cv::TermCriteria::EPS, 100, 1e-10});
    return camera;
}

double information_criterion(double rms_px, std::size_t corners, int parameters) {
    const double n = 2.0 * static_cast<double>(corners) / kCornersPerObservation;
    return n * std::log(std::max(rms_px * rms_px, 1e-12)) + parameters * std::log(n);
}

double largest_tilt_deg(const std::vector<cv::Mat>& rotations) {
    std::vector<Eigen::Vector3d> normals;
    for (const cv::Mat& r : rotations) {
        cv::Mat R;
        cv::Rodrigues(r, R);
        normals.emplace_back(R.at<double>(0, 2), R.at<double>(1, 2), R.at<double>(2, 2));
    }
    double least_cosine = 1.0;
    for (const auto& a : normals) {
        for (const auto& b : normals) least_cosine = std::min(least_cosine, a.dot(b));
    }
    return deg_from_rad(std::acos(std::clamp(least_cosine, -1.0, 1.0)));
}

std::vector<double> numbers(const cv::Mat& m) {
    cv::Mat1d row = m.reshape(1, 1);
    return {row.begin(), row.end()};
}

StereoRig rig_from(const Camera& left, const Camera& right, const cv::Mat& R, const cv::Mat& T,
                   ImageSize image) {
    StereoRig rig;
    rig.image = image;
    cv::cv2eigen(left.K, rig.K_left);
    cv::cv2eigen(right.K, rig.K_right);
    rig.D_left = numbers(left.D);
    rig.D_right = numbers(right.D);
    Eigen::Matrix3d rotation;
    Eigen::Vector3d translation;
    cv::cv2eigen(R, rotation);
    cv::cv2eigen(T, translation);
    rig.T_right_left.linear() = rotation;
    rig.T_right_left.translation() = translation;
    return rig;
}

struct Rectification {
    cv::Mat K1, D1, K2, D2, R1, R2, P1, P2;

    explicit Rectification(const StereoRig& rig) {
        cv::Mat R, T, Q;
        cv::eigen2cv(rig.K_left, K1);
        cv::eigen2cv(rig.K_right, K2);
        cv::eigen2cv(Eigen::Matrix3d(rig.T_right_left.linear()), R);
        cv::eigen2cv(Eigen::Vector3d(rig.T_right_left.translation()), T);
        D1 = cv::Mat(rig.D_left, true);
        D2 = cv::Mat(rig.D_right, true);
        cv::stereoRectify(K1, D1, K2, D2, {rig.image.width, rig.image.height}, R, T, R1, R2, P1, P2,
                          Q, cv::CALIB_ZERO_DISPARITY, -1);
    }
    std::vector<cv::Point2f> left(const std::vector<cv::Point2f>& corners) const {
        std::vector<cv::Point2f> out;
        cv::undistortPoints(corners, out, K1, D1, R1, P1);
        return out;
    }
    std::vector<cv::Point2f> right(const std::vector<cv::Point2f>& corners) const {
        std::vector<cv::Point2f> out;
        cv::undistortPoints(corners, out, K2, D2, R2, P2);
        return out;
    }
};

/// The corners of all views as OpenCV wants them.
struct Corners {
    Points3 board;
    Points2 left_px, right_px;
    std::size_t count = 0;

    explicit Corners(const std::vector<CornerPairs>& views) {
        for (const CornerPairs& view : views) {
            board.push_back(view.board_m);
            left_px.push_back(view.left_px);
            right_px.push_back(view.right_px);
            count += view.board_m.size();
        }
    }
};

struct Cameras {
    Camera left, right;
    const Model* model = nullptr;
};

/// Both cameras alone, with the model that the corners ask for.
Cameras fit_cameras(const Corners& corners, cv::Size size) {
    Cameras best;
    double least = 0.0;
    for (const Model& model : kModels) {
        Camera l = fit_camera(corners.board, corners.left_px, size, model.flags);
        Camera r = fit_camera(corners.board, corners.right_px, size, model.flags);
        const double criterion = information_criterion(l.rms_px, corners.count, model.parameters) +
                                 information_criterion(r.rms_px, corners.count, model.parameters);
        if (best.model != nullptr && criterion >= least) continue;
        least = criterion;
        best = {std::move(l), std::move(r), &model};
    }
    return best;
}

StereoFit fit(const std::vector<CornerPairs>& views, ImageSize image) {
    const Corners corners(views);
    const cv::Size size(image.width, image.height);
    Cameras cameras = fit_cameras(corners, size);
    cv::Mat R, T, E, F, per_view;
    StereoFit result;
    result.rms_px =
        cv::stereoCalibrate(corners.board, corners.left_px, corners.right_px, cameras.left.K,
                            cameras.left.D, cameras.right.K, cameras.right.D, size, R, T, E, F,
                            per_view, cameras.model->flags | cv::CALIB_USE_INTRINSIC_GUESS,
                            {cv::TermCriteria::COUNT + cv::TermCriteria::EPS, 200, 1e-10});
    result.rig = rig_from(cameras.left, cameras.right, R, T, image);
    result.distortion_model = cameras.model->name;
    result.tilt_deg = largest_tilt_deg(cameras.left.rotations);
    for (int i = 0; i < per_view.rows; ++i) {
        result.rms_left_px.push_back(per_view.at<double>(i, 0));
        result.rms_right_px.push_back(per_view.at<double>(i, 1));
    }
    return result;
}

}  // namespace

Result<StereoFit> fit_stereo(const std::vector<CornerPairs>& views, ImageSize image) {
    try {
        return fit(views, image);
    } catch (const cv::Exception& e) {
        return input_error("the corners fit no camera: {}", e.err);
    }
}

std::vector<double> row_errors_px(const StereoRig& rig, const std::vector<CornerPairs>& views) {
    const Rectification rectification(rig);
    std::vector<double> errors;
    for (const CornerPairs& view : views) {
        const auto left = rectification.left(view.left_px);
        const auto right = rectification.right(view.right_px);
        for (std::size_t i = 0; i < left.size(); ++i) {
            errors.push_back(static_cast<double>(right[i].y) - static_cast<double>(left[i].y));
        }
    }
    return errors;
}

std::vector<cv::Point3d> triangulate_corners(const StereoRig& rig, const CornerPairs& view) {
    const Rectification rectification(rig);
    const auto left = rectification.left(view.left_px);
    const auto right = rectification.right(view.right_px);
    const double f = rectification.P1.at<double>(0, 0);
    const double baseline = -rectification.P2.at<double>(0, 3) / f;
    const double cx = rectification.P1.at<double>(0, 2);
    const double cy = rectification.P1.at<double>(1, 2);
    std::vector<cv::Point3d> points;
    for (std::size_t i = 0; i < left.size(); ++i) {
        const double disparity = static_cast<double>(left[i].x) - static_cast<double>(right[i].x);
        const double z = f * baseline / disparity;
        points.emplace_back((static_cast<double>(left[i].x) - cx) * z / f,
                            (static_cast<double>(left[i].y) - cy) * z / f, z);
    }
    return points;
}

}  // namespace gripscan
