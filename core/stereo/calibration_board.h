// Calibration boards and their corners in an image.
#pragma once

#include <opencv2/core/mat.hpp>
#include <string>
#include <variant>
#include <vector>

#include "core/base/result.h"

namespace gripscan {

/// A chessboard by its inner corners.
struct Chessboard {
    int cols = 0;
    int rows = 0;
    double square_m = 0.0;
};

/// A ChArUco board by its squares, as OpenCV 4.6 draws it (a marker in the second square of the
/// first row).
struct CharucoBoard {
    int squares_x = 0;
    int squares_y = 0;
    double square_m = 0.0;
    double marker_m = 0.0;
    std::string dictionary;  ///< "DICT_5X5_100" or "5X5_100"
};

using CalibrationBoard = std::variant<Chessboard, CharucoBoard>;

/// Errors: sizes that make no board, an unknown dictionary.
[[nodiscard]] Status validate(const CalibrationBoard& board);

/// Corner positions on the board, m, by corner number (row-major), z = 0.
[[nodiscard]] std::vector<cv::Point3f> board_points_m(const CalibrationBoard& board);

/// Corners seen in an image: their numbers, rising, and positions, px. Empty: no board found.
/// A chessboard is found whole or not at all, and may be numbered from either end.
struct BoardView {
    std::vector<int> number;
    std::vector<cv::Point2f> corner_px;
};

[[nodiscard]] BoardView find_board(const cv::Mat& grey, const CalibrationBoard& board);

/// Renumbers the right view of a chessboard so that it starts at the same corner as the left one:
/// the cameras stand side by side, so the board lies the same way in both images.
[[nodiscard]] BoardView in_order_of(const BoardView& left, const BoardView& right,
                                    const CalibrationBoard& board);

}  // namespace gripscan
