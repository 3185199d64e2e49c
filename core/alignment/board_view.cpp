#include "core/alignment/board_view.h"

#include <algorithm>
#include <cmath>
#include <opencv2/calib3d.hpp>
#include <opencv2/core/eigen.hpp>
#include <opencv2/imgproc.hpp>

#include "core/alignment/board_pose.h"
#include "core/stereo/rectifier.h"

namespace gripscan {
namespace {

constexpr std::size_t kFewestCorners = 8;

Status check_board(const CalibrationBoard& board) {
    if (Status valid = validate(board); !valid) return valid;
    const auto* chess = std::get_if<Chessboard>(&board);
    if (chess != nullptr && (chess->cols + chess->rows) % 2 == 0) {
        return input_error(
            "a chessboard of {} x {} inner corners looks the same after half a turn; use one with "
            "an odd sum, such as 9 x 6, or a ChArUco board",
            chess->cols, chess->rows);
    }
    return {};
}

cv::Mat cv_matrix(const Eigen::Matrix3d& M) {
    cv::Mat result;
    cv::eigen2cv(M, result);
    return result;
}

/// Mean brightness in the middle of the square right below and after corner (column, row).
double square_brightness(const cv::Mat& grey, const BoardView& view, int columns, int column,
                         int row) {
    cv::Point2f middle(0, 0);
    for (const int c : {column, column + 1}) {
        for (const int r : {row, row + 1}) {
            middle += 0.25F * view.corner_px[static_cast<std::size_t>(r * columns + c)];
        }
    }
    cv::Mat patch;
    cv::getRectSubPix(grey, {3, 3}, middle, patch);
    return cv::mean(patch)[0];
}

/// The same corner is the first one in every view: that beside which the inner square is dark.
BoardView oriented(const cv::Mat& grey, BoardView view, const CalibrationBoard& board) {
    const auto* chess = std::get_if<Chessboard>(&board);
    if (chess == nullptr || view.number.empty()) return view;
    double first = 0.0;
    double second = 0.0;
    for (int row = 0; row + 1 < chess->rows; ++row) {
        for (int column = 0; column + 1 < chess->cols; ++column) {
            const double value = square_brightness(grey, view, chess->cols, column, row);
            ((row + column) % 2 == 0 ? first : second) += value;
        }
    }
    const int squares = (chess->rows - 1) * (chess->cols - 1);
    const int firsts = (squares + 1) / 2;
    if (first / firsts > second / (squares - firsts)) {
        std::reverse(view.corner_px.begin(), view.corner_px.end());
    }
    return view;
}

std::vector<cv::Point2f> undistorted(const std::vector<cv::Point2f>& corners, const cv::Mat& K,
                                     const std::vector<double>& D, const cv::Mat& R) {
    std::vector<cv::Point2f> result;
    cv::undistortPoints(corners, result, K, D, R, cv::noArray(),
                        {cv::TermCriteria::COUNT + cv::TermCriteria::EPS, 40, 1e-9});
    return result;
}

Eigen::Vector2d pixel(const RectifiedRig& camera, double cx_px, const cv::Point2f& p) {
    return {camera.f_px * static_cast<double>(p.x) + cx_px,
            camera.f_px * static_cast<double>(p.y) + camera.cy_px};
}

}  // namespace

Result<BoardEye> BoardEye::create(const StereoRig& rig, const CalibrationBoard& board) {
    if (Status valid = check_board(board); !valid) return forward_error(valid.error());
    const auto rectifier = Rectifier::create(rig);
    if (!rectifier) return forward_error(rectifier.error());
    BoardEye eye(board);
    eye.rig_ = rig;
    eye.camera_ = rectifier->rig();
    const Eigen::Matrix3d R_left = rectifier->R_rectified_left();
    eye.R_left_ = cv_matrix(R_left);
    eye.R_right_ = cv_matrix(R_left * rig.T_right_left.linear().transpose());
    return eye;
}

Result<BoardEye> BoardEye::create(const MonoCamera& camera, const CalibrationBoard& board) {
    if (Status valid = check_board(board); !valid) return forward_error(valid.error());
    if (!(camera.fx_px > 0.0 && camera.fy_px > 0.0)) {
        return input_error("focal lengths of {} and {} px make no camera", camera.fx_px,
                           camera.fy_px);
    }
    BoardEye eye(board);
    eye.mono_ = camera;
    eye.camera_.f_px = 0.5 * (camera.fx_px + camera.fy_px);
    eye.camera_.cx_left_px = eye.camera_.cx_right_px = camera.cx_px;
    eye.camera_.cy_px = camera.cy_px;
    eye.R_left_ = cv::Mat::eye(3, 3, CV_64F);
    return eye;
}

std::optional<BoardObservation> BoardEye::look(const cv::Mat& left, const cv::Mat& right) const {
    const BoardView seen = oriented(left, find_board(left, board_), board_);
    if (seen.number.size() < kFewestCorners) return std::nullopt;
    const auto points = board_points_m(board_);
    BoardView other;
    if (stereo()) {
        other = oriented(right, find_board(right, board_), board_);
        if (other.number.empty()) return std::nullopt;
    }
    Eigen::Matrix3d K = rig_ ? rig_->K_left : Eigen::Matrix3d::Identity();
    if (!rig_) K << mono_.fx_px, 0, mono_.cx_px, 0, mono_.fy_px, mono_.cy_px, 0, 0, 1;
    const auto lefts =
        undistorted(seen.corner_px, cv_matrix(K), rig_ ? rig_->D_left : mono_.distortion, R_left_);
    std::vector<cv::Point2f> rights;
    if (rig_) {
        rights = undistorted(other.corner_px, cv_matrix(rig_->K_right), rig_->D_right, R_right_);
    }
    BoardObservation observation;
    for (std::size_t i = 0; i < seen.number.size(); ++i) {
        if (rig_) {
            const auto at = std::find(other.number.begin(), other.number.end(), seen.number[i]);
            if (at == other.number.end()) continue;
            const auto k = static_cast<std::size_t>(at - other.number.begin());
            observation.right_px.push_back(pixel(camera_, camera_.cx_right_px, rights[k]));
        }
        const cv::Point3f& p = points[static_cast<std::size_t>(seen.number[i])];
        observation.board_m.push_back(Eigen::Vector3f(p.x, p.y, p.z).cast<double>());
        observation.left_px.push_back(pixel(camera_, camera_.cx_left_px, lefts[i]));
    }
    if (observation.board_m.size() < kFewestCorners) return std::nullopt;
    if (!estimate_board_pose(camera_, observation)) return std::nullopt;
    return observation;
}

}  // namespace gripscan
