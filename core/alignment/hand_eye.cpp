#include "core/alignment/hand_eye.h"

#include <Eigen/Eigenvalues>
#include <Eigen/SVD>
#include <algorithm>
#include <array>
#include <cmath>
#include <opencv2/calib3d.hpp>
#include <opencv2/core/eigen.hpp>
#include <optional>

#include "core/base/units.h"

namespace gripscan {
namespace {

struct CvPoses {
    std::vector<cv::Mat> R;
    std::vector<cv::Mat> t;

    void add(const Pose& T) {
        cv::Mat rotation;
        cv::Mat translation;
        cv::eigen2cv(Eigen::Matrix3d(T.linear()), rotation);
        cv::eigen2cv(Eigen::Vector3d(T.translation()), translation);
        R.push_back(rotation);
        t.push_back(translation);
    }
};

std::optional<Pose> rigid(const cv::Mat& R, const cv::Mat& t) {
    if (R.rows != 3 || R.cols != 3 || t.total() != 3) return std::nullopt;
    Eigen::Matrix3d rotation;
    Eigen::Vector3d translation;
    cv::cv2eigen(R, rotation);
    cv::cv2eigen(t.reshape(1, 3), translation);
    if (!rotation.allFinite() || !translation.allFinite()) return std::nullopt;
    const Eigen::JacobiSVD<Eigen::Matrix3d> svd(rotation,
                                                Eigen::ComputeFullU | Eigen::ComputeFullV);
    Pose T = Pose::Identity();
    T.linear() = svd.matrixU() * svd.matrixV().transpose();
    if (T.linear().determinant() < 0.0) return std::nullopt;
    T.translation() = translation;
    return T;
}

struct Method {
    const char* name;
    int number;
    bool both;  ///< solves X and Y together
};
constexpr std::array<Method, 7> kMethods = {{{"Park", cv::CALIB_HAND_EYE_PARK, false},
                                             {"Horaud", cv::CALIB_HAND_EYE_HORAUD, false},
                                             {"Tsai", cv::CALIB_HAND_EYE_TSAI, false},
                                             {"Daniilidis", cv::CALIB_HAND_EYE_DANIILIDIS, false},
                                             {"Andreff", cv::CALIB_HAND_EYE_ANDREFF, false},
                                             {"Shah", cv::CALIB_ROBOT_WORLD_HAND_EYE_SHAH, true},
                                             {"Li", cv::CALIB_ROBOT_WORLD_HAND_EYE_LI, true}}};

std::optional<Pose> solve(const Method& method, std::span<const HandEyeView> views,
                          Mounting mounting) {
    CvPoses moved;
    CvPoses seen;
    for (const HandEyeView& view : views) {
        const Pose A = fixed_side(view, mounting);
        moved.add(method.both ? A.inverse() : A);
        seen.add(view.T_camera_board);
    }
    try {
        cv::Mat R, t;
        if (!method.both) {
            cv::calibrateHandEye(moved.R, moved.t, seen.R, seen.t, R, t,
                                 static_cast<cv::HandEyeCalibrationMethod>(method.number));
            return rigid(R, t);
        }
        cv::Mat R_board, t_board;
        cv::calibrateRobotWorldHandEye(
            seen.R, seen.t, moved.R, moved.t, R_board, t_board, R, t,
            static_cast<cv::RobotWorldHandEyeCalibrationMethod>(method.number));
        const auto inverse = rigid(R, t);
        if (!inverse) return std::nullopt;
        return inverse->inverse();
    } catch (const cv::Exception&) {
        return std::nullopt;  // a method that gives up is one candidate fewer
    }
}

Eigen::Matrix3d nearest_rotation(const Eigen::Matrix3d& M) {
    const Eigen::JacobiSVD<Eigen::Matrix3d> svd(M, Eigen::ComputeFullU | Eigen::ComputeFullV);
    Eigen::Matrix3d U = svd.matrixU();
    if ((U * svd.matrixV().transpose()).determinant() < 0.0) U.col(2) *= -1.0;
    return U * svd.matrixV().transpose();
}

}  // namespace

Pose mean_board(std::span<const HandEyeView> views, Mounting mounting, const Pose& X) {
    Eigen::Matrix3d rotations = Eigen::Matrix3d::Zero();
    Eigen::Vector3d shifts = Eigen::Vector3d::Zero();
    for (const HandEyeView& view : views) {
        const Pose board = fixed_side(view, mounting) * X * view.T_camera_board;
        rotations += board.linear();
        shifts += board.translation();
    }
    Pose mean = Pose::Identity();
    mean.linear() = nearest_rotation(rotations);
    mean.translation() = shifts / static_cast<double>(views.size());
    return mean;
}

BoardSpread board_spread(std::span<const HandEyeView> views, Mounting mounting,
                         const HandEyePoses& poses) {
    BoardSpread spread;
    for (const HandEyeView& view : views) {
        const Pose apart =
            poses.Y.inverse() * fixed_side(view, mounting) * poses.X * view.T_camera_board;
        const double metres = apart.translation().norm();
        const double angle = rotation_angle_rad(apart.linear());
        spread.rms_m += metres * metres;
        spread.rms_rad += angle * angle;
        spread.max_m = std::max(spread.max_m, metres);
        spread.max_rad = std::max(spread.max_rad, angle);
    }
    const auto n = static_cast<double>(views.size());
    spread.rms_m = std::sqrt(spread.rms_m / n);
    spread.rms_rad = std::sqrt(spread.rms_rad / n);
    return spread;
}

Status check_views(std::span<const HandEyeView> views) {
    constexpr std::size_t kFewest = 3;
    constexpr double kLeastTurn_deg = 10.0;
    constexpr double kLeastTilt_deg = 10.0;
    if (views.size() < kFewest) {
        return input_error(
            "an alignment needs at least {} views of the board, better ten; there {} {}", kFewest,
            views.size() == 1 ? "is" : "are", views.size());
    }
    // The axes of all turns between two views, weighted by how well they are known.
    Eigen::Matrix3d axes = Eigen::Matrix3d::Zero();
    double largest_rad = 0.0;
    for (std::size_t i = 0; i < views.size(); ++i) {
        for (std::size_t j = i + 1; j < views.size(); ++j) {
            const Eigen::Matrix3d R =
                views[i].T_robot_flange.linear().transpose() * views[j].T_robot_flange.linear();
            const double angle = rotation_angle_rad(R);
            largest_rad = std::max(largest_rad, angle);
            const Eigen::Vector3d turn =
                2.0 * std::sin(angle / 2.0) * rotation_vector(R).stableNormalized();
            axes += turn * turn.transpose();
        }
    }
    if (largest_rad < rad_from_deg(kLeastTurn_deg)) {
        return input_error(
            "the poses differ by {:.1f} deg at most: the flange must be turned by {:.0f} deg and "
            "more between views, about different axes",
            deg_from_rad(largest_rad), kLeastTurn_deg);
    }
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(axes);
    const double ratio = std::max(0.0, solver.eigenvalues()(1)) / solver.eigenvalues()(2);
    const double tilt_rad = std::atan(std::sqrt(ratio));
    if (tilt_rad < rad_from_deg(kLeastTilt_deg)) {
        return input_error(
            "all poses turn about one axis (their axes spread by {:.1f} deg; was joint 6 turned "
            "alone?): the shift along it and the turn about it cannot be known; tilt the flange "
            "with joints 4 and 5 too, by 20 deg and more",
            deg_from_rad(tilt_rad));
    }
    return {};
}

Result<std::vector<HandEyeCandidate>> solve_hand_eye(std::span<const HandEyeView> views,
                                                     Mounting mounting) {
    if (Status possible = check_views(views); !possible) return forward_error(possible.error());
    std::vector<HandEyeCandidate> candidates;
    for (const Method& method : kMethods) {
        const auto X = solve(method, views, mounting);
        if (!X) continue;
        const HandEyePoses poses{*X, mean_board(views, mounting, *X)};
        candidates.push_back({method.name, poses, board_spread(views, mounting, poses)});
    }
    if (!candidates.empty()) return candidates;
    return input_error("no method found an alignment: do the poses belong to the images?");
}

const HandEyeCandidate& best_of(const std::vector<HandEyeCandidate>& candidates) {
    constexpr double kAsGood = 1.02;
    const auto best = std::min_element(candidates.begin(), candidates.end(),
                                       [](const HandEyeCandidate& a, const HandEyeCandidate& b) {
                                           return a.spread.cost_m() < b.spread.cost_m();
                                       });
    const HandEyeCandidate& first = candidates.front();
    return first.spread.cost_m() <= kAsGood * best->spread.cost_m() + 1e-9 ? first : *best;
}

}  // namespace gripscan
