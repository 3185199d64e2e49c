#include "tests/unit/stereo/board_images.h"

#include <cmath>
#include <opencv2/aruco/charuco.hpp>
#include <opencv2/calib3d.hpp>
#include <opencv2/core/eigen.hpp>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include "core/base/seeded_random.h"

namespace gripscan::test {
namespace {

constexpr int kPxPerSquare = 60;

/// The printed board with a white margin of one square; the first corner lies at (origin, origin).
struct Print {
    cv::Mat image;
    double origin_px;
    double m_per_px;
};

Print print_of(const Chessboard& board) {
    const int margin = kPxPerSquare;
    cv::Mat image(kPxPerSquare * (board.rows + 1) + 2 * margin,
                  kPxPerSquare * (board.cols + 1) + 2 * margin, CV_8U, cv::Scalar(230));
    for (int row = 0; row <= board.rows; ++row) {
        for (int column = row % 2; column <= board.cols; column += 2) {
            image(cv::Rect(margin + column * kPxPerSquare, margin + row * kPxPerSquare,
                           kPxPerSquare, kPxPerSquare))
                .setTo(25);
        }
    }
    return {image, margin + kPxPerSquare - 0.5, board.square_m / kPxPerSquare};
}

Print print_of(const CharucoBoard& board) {
    const int margin = kPxPerSquare;
    const auto model = cv::aruco::CharucoBoard::create(
        board.squares_x, board.squares_y, static_cast<float>(board.square_m),
        static_cast<float>(board.marker_m),
        cv::aruco::getPredefinedDictionary(cv::aruco::DICT_5X5_100));
    cv::Mat drawn;
    model->draw({board.squares_x * kPxPerSquare, board.squares_y * kPxPerSquare}, drawn, 0, 1);
    cv::Mat image;
    cv::copyMakeBorder(drawn, image, margin, margin, margin, margin, cv::BORDER_CONSTANT, 255);
    image = image * 0.8 + 25;
    return {image, margin + kPxPerSquare - 0.5, board.square_m / kPxPerSquare};
}

/// OpenCV 4.6 numbers ChArUco corners from the bottom of the drawing: y up.
bool y_points_up(const CalibrationBoard& board) {
    return std::holds_alternative<CharucoBoard>(board);
}

constexpr int kFine = 2;  ///< samples per pixel and direction

/// Viewing directions (x, y, 1) of all samples of a camera, CV_64FC2.
cv::Mat rays_of(const Eigen::Matrix3d& K, const std::vector<double>& D, ImageSize size) {
    cv::Mat Kcv, rays;
    cv::eigen2cv(K, Kcv);
    cv::Mat samples(size.height * kFine, size.width * kFine, CV_64FC2);
    for (int y = 0; y < samples.rows; ++y) {
        for (int x = 0; x < samples.cols; ++x) {
            samples.at<cv::Vec2d>(y, x) = {(x + 0.5) / kFine - 0.5, (y + 0.5) / kFine - 0.5};
        }
    }
    cv::undistortPoints(samples.reshape(2, 1), rays, Kcv, D, cv::noArray(), cv::noArray(),
                        {cv::TermCriteria::COUNT + cv::TermCriteria::EPS, 20, 1e-8});
    return rays.reshape(2, samples.rows);
}

cv::Mat take(const Print& print, bool flipped, double last_corner_y_m, const cv::Mat& rays,
             const Pose& T_camera_board, std::uint64_t seed) {
    const Eigen::Matrix3d R_board_camera = T_camera_board.linear().transpose();
    const Eigen::Vector3d camera = -R_board_camera * T_camera_board.translation();
    cv::Mat map_x(rays.size(), CV_32F);
    cv::Mat map_y(rays.size(), CV_32F);
    for (int y = 0; y < map_x.rows; ++y) {
        for (int x = 0; x < map_x.cols; ++x) {
            const auto& r = rays.at<cv::Vec2d>(y, x);
            const Eigen::Vector3d ray = R_board_camera * Eigen::Vector3d(r[0], r[1], 1.0);
            const Eigen::Vector3d p = camera - ray * (camera.z() / ray.z());
            const double down_m = flipped ? last_corner_y_m - p.y() : p.y();
            map_x.at<float>(y, x) = static_cast<float>(print.origin_px + p.x() / print.m_per_px);
            map_y.at<float>(y, x) = static_cast<float>(print.origin_px + down_m / print.m_per_px);
        }
    }
    cv::Mat fine, image;
    cv::remap(print.image, fine, map_x, map_y, cv::INTER_LINEAR, cv::BORDER_CONSTANT, 120);
    cv::resize(fine, image, {}, 1.0 / kFine, 1.0 / kFine, cv::INTER_AREA);
    cv::GaussianBlur(image, image, {}, 0.6);
    SeededRandom random(seed);
    for (int y = 0; y < image.rows; ++y) {
        for (int x = 0; x < image.cols; ++x) {
            uchar& grey = image.at<uchar>(y, x);
            grey = cv::saturate_cast<uchar>(grey + 1.5 * random.normal());
        }
    }
    return image;
}

}  // namespace

BoardFiles write_board_images(const std::filesystem::path& folder, const StereoRig& rig,
                              const CalibrationBoard& board, const std::vector<BoardPose>& poses) {
    std::filesystem::create_directories(folder);
    const Print print = std::visit([](const auto& b) { return print_of(b); }, board);
    const bool flipped = y_points_up(board);
    const double last_y_m = static_cast<double>(board_points_m(board).back().y);
    const cv::Mat left_rays = rays_of(rig.K_left, rig.D_left, rig.image);
    const cv::Mat right_rays = rays_of(rig.K_right, rig.D_right, rig.image);
    BoardFiles files;
    for (std::size_t i = 0; i < poses.size(); ++i) {
        files.lefts.push_back(folder / ("left" + std::to_string(10 + i) + ".png"));
        files.rights.push_back(folder / ("right" + std::to_string(10 + i) + ".png"));
        cv::imwrite(files.lefts.back().string(),
                    take(print, flipped, last_y_m, left_rays, poses[i], 2 * i + 1));
        cv::imwrite(files.rights.back().string(), take(print, flipped, last_y_m, right_rays,
                                                       rig.T_right_left * poses[i], 2 * i + 2));
    }
    return files;
}

StereoRig distorted_rig() {
    StereoRig rig;
    rig.image = {640, 480};
    rig.K_left << 700.0, 0.0, 318.0, 0.0, 702.0, 242.0, 0.0, 0.0, 1.0;
    rig.K_right << 705.0, 0.0, 323.0, 0.0, 706.0, 237.0, 0.0, 0.0, 1.0;
    rig.D_left = {-0.20, 0.10, 0.0, 0.0, 0.0};
    rig.D_right = {-0.21, 0.11, 0.0, 0.0, 0.0};
    rig.T_right_left.linear() = rotation_from_vector({0.004, 0.03, -0.006});
    rig.T_right_left.translation() = Eigen::Vector3d(-0.100, 0.001, 0.002);
    return rig;
}

std::vector<BoardPose> board_poses(const CalibrationBoard& board, int count, double distance_m,
                                   double tilt_rad) {
    SeededRandom random(7);
    const cv::Point3f last = board_points_m(board).back();
    const Eigen::Vector3d middle(0.5 * static_cast<double>(last.x),
                                 0.5 * static_cast<double>(last.y), 0.0);
    const bool flipped = y_points_up(board);
    std::vector<BoardPose> poses;
    for (int i = 0; i < count; ++i) {
        const double direction = 2.0 * 3.14159265358979 * i / count;
        const double tilt = tilt_rad * (0.5 + 0.5 * random.uniform());
        Pose T = Pose::Identity();
        T.linear() = rotation_from_vector(
            {tilt * std::cos(direction), tilt * std::sin(direction), random.uniform(-0.15, 0.15)});
        // With y up the board's z would point at the camera: turned half about x.
        if (flipped) T.linear() *= Eigen::Vector3d(1.0, -1.0, -1.0).asDiagonal();
        const Eigen::Vector3d centre(random.uniform(-0.04, 0.11), random.uniform(-0.05, 0.05),
                                     distance_m * random.uniform(0.9, 1.1));
        T.translation() = centre - T.linear() * middle;
        poses.push_back(T);
    }
    return poses;
}

}  // namespace gripscan::test
