#include "core/stereo/calibration_board.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <opencv2/aruco/charuco.hpp>
#include <opencv2/calib3d.hpp>
#include <opencv2/imgproc.hpp>
#include <optional>

namespace gripscan {
namespace {

std::optional<cv::aruco::PREDEFINED_DICTIONARY_NAME> dictionary_of(std::string name) {
    constexpr std::array kNames{
        "4X4_50",        "4X4_100",        "4X4_250",       "4X4_1000",      "5X5_50",
        "5X5_100",       "5X5_250",        "5X5_1000",      "6X6_50",        "6X6_100",
        "6X6_250",       "6X6_1000",       "7X7_50",        "7X7_100",       "7X7_250",
        "7X7_1000",      "ARUCO_ORIGINAL", "APRILTAG_16h5", "APRILTAG_25h9", "APRILTAG_36h10",
        "APRILTAG_36h11"};
    if (name.starts_with("DICT_")) name = name.substr(5);
    const auto at = std::find(kNames.begin(), kNames.end(), name);
    if (at == kNames.end()) return std::nullopt;
    return static_cast<cv::aruco::PREDEFINED_DICTIONARY_NAME>(at - kNames.begin());
}

cv::Ptr<cv::aruco::CharucoBoard> charuco(const CharucoBoard& board) {
    return cv::aruco::CharucoBoard::create(
        board.squares_x, board.squares_y, static_cast<float>(board.square_m),
        static_cast<float>(board.marker_m),
        cv::aruco::getPredefinedDictionary(*dictionary_of(board.dictionary)));
}

/// Corners in a row; a ChArUco board has one fewer than squares.
int columns_of(const CalibrationBoard& board) {
    if (const auto* chess = std::get_if<Chessboard>(&board)) return chess->cols;
    return std::get<CharucoBoard>(board).squares_x - 1;
}

int rows_of(const CalibrationBoard& board) {
    if (const auto* chess = std::get_if<Chessboard>(&board)) return chess->rows;
    return std::get<CharucoBoard>(board).squares_y - 1;
}

Status validate_board(const Chessboard& board) {
    if (board.cols < 3 || board.rows < 3 || board.cols > 100 || board.rows > 100) {
        return input_error(
            "a chessboard of {} x {} inner corners cannot be used; count the inner "
            "corners (at least 3 x 3)",
            board.cols, board.rows);
    }
    if (!(board.square_m > 0.0 && board.square_m < 10.0)) {
        return input_error("squares of {} m make no chessboard", board.square_m);
    }
    return {};
}

Status validate_board(const CharucoBoard& board) {
    if (board.squares_x < 3 || board.squares_y < 3 || board.squares_x > 100 ||
        board.squares_y > 100) {
        return input_error("a ChArUco board of {} x {} squares cannot be used (at least 3 x 3)",
                           board.squares_x, board.squares_y);
    }
    if (!(board.marker_m > 0.0 && board.marker_m < board.square_m && board.square_m < 10.0)) {
        return input_error("markers of {} m in squares of {} m make no ChArUco board",
                           board.marker_m, board.square_m);
    }
    const auto dictionary = dictionary_of(board.dictionary);
    if (!dictionary) {
        return input_error(
            "unknown marker dictionary '{}'; use a name of OpenCV such as "
            "DICT_5X5_100",
            board.dictionary);
    }
    const int markers = board.squares_x * board.squares_y / 2;
    const int available = cv::aruco::getPredefinedDictionary(*dictionary)->bytesList.rows;
    if (markers > available) {
        return input_error("the board needs {} markers, dictionary {} has {}", markers,
                           board.dictionary, available);
    }
    return {};
}

/// Half the window of the corner refinement: it must not reach the next corner.
cv::Size refinement_window(const std::vector<cv::Point2f>& corners) {
    double nearest = std::numeric_limits<double>::max();
    for (std::size_t i = 1; i < corners.size(); ++i) {
        nearest = std::min(nearest, cv::norm(corners[i] - corners[i - 1]));
    }
    const int half = std::clamp(static_cast<int>(0.4 * nearest), 2, 11);
    return {half, half};
}

BoardView find(const cv::Mat& grey, const Chessboard& board) {
    BoardView view;
    const cv::Size size(board.cols, board.rows);
    std::vector<cv::Point2f> corners;
    if (!cv::findChessboardCorners(grey, size, corners,
                                   cv::CALIB_CB_ADAPTIVE_THRESH | cv::CALIB_CB_NORMALIZE_IMAGE)) {
        if (!cv::findChessboardCornersSB(grey, size, corners, cv::CALIB_CB_EXHAUSTIVE)) return view;
    }
    cv::cornerSubPix(grey, corners, refinement_window(corners), {-1, -1},
                     {cv::TermCriteria::COUNT + cv::TermCriteria::EPS, 60, 1e-4});
    view.corner_px = corners;
    for (int i = 0; i < size.area(); ++i) view.number.push_back(i);
    return view;
}

BoardView find(const cv::Mat& grey, const CharucoBoard& board) {
    const auto model = charuco(board);
    std::vector<std::vector<cv::Point2f>> markers;
    std::vector<int> ids;
    auto parameters = cv::aruco::DetectorParameters::create();
    cv::aruco::detectMarkers(grey, model->dictionary, markers, ids, parameters);
    BoardView view;
    if (ids.size() < 2) return view;
    std::vector<cv::Point2f> corners;
    std::vector<int> numbers;
    cv::aruco::interpolateCornersCharuco(markers, ids, grey, model, corners, numbers);
    view.corner_px = corners;
    view.number = numbers;
    return view;
}

/// Number that corner (column, row) gets when the board is turned by quarter turns.
int turned(int column, int row, int columns, int rows, int quarters) {
    for (int i = 0; i < quarters; ++i) {
        const int next_column = rows - 1 - row;
        row = column;
        column = next_column;
        std::swap(columns, rows);
    }
    return row * columns + column;
}

}  // namespace

Status validate(const CalibrationBoard& board) {
    return std::visit([](const auto& b) { return validate_board(b); }, board);
}

std::vector<cv::Point3f> board_points_m(const CalibrationBoard& board) {
    const double square = std::visit([](const auto& b) { return b.square_m; }, board);
    std::vector<cv::Point3f> points;
    for (int row = 0; row < rows_of(board); ++row) {
        for (int column = 0; column < columns_of(board); ++column) {
            points.emplace_back(static_cast<float>(column * square),
                                static_cast<float>(row * square), 0.0F);
        }
    }
    return points;
}

BoardView find_board(const cv::Mat& grey, const CalibrationBoard& board) {
    return std::visit([&](const auto& b) { return find(grey, b); }, board);
}

BoardView in_order_of(const BoardView& left, const BoardView& right,
                      const CalibrationBoard& board) {
    if (!std::holds_alternative<Chessboard>(board) || left.number.empty() || right.number.empty()) {
        return right;
    }
    const int columns = columns_of(board);
    const int rows = rows_of(board);
    BoardView best = right;
    double least = std::numeric_limits<double>::max();
    // A board with as many rows as columns may also be numbered along its other side.
    for (int quarters = 0; quarters < 4; quarters += columns == rows ? 1 : 2) {
        BoardView candidate = right;
        for (int i = 0; i < columns * rows; ++i) {
            const int to = turned(i % columns, i / columns, columns, rows, quarters);
            candidate.corner_px[static_cast<std::size_t>(to)] =
                right.corner_px[static_cast<std::size_t>(i)];
        }
        cv::Scalar mean_shift;
        double apart = 0.0;
        std::vector<cv::Point2f> shift(left.corner_px.size());
        for (std::size_t i = 0; i < shift.size(); ++i) {
            shift[i] = candidate.corner_px[i] - left.corner_px[i];
        }
        mean_shift = cv::mean(shift);
        for (const cv::Point2f& s : shift) {
            apart += std::pow(static_cast<double>(s.x) - mean_shift[0], 2) +
                     std::pow(static_cast<double>(s.y) - mean_shift[1], 2);
        }
        if (apart < least) {
            least = apart;
            best = candidate;
        }
    }
    return best;
}

}  // namespace gripscan
