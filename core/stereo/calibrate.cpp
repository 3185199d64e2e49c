#include "core/stereo/calibrate.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/camera/image_file.h"
#include "core/stereo/stereo_fit.h"

namespace gripscan {
namespace fs = std::filesystem;
namespace {

/// Fewer common corners do not tie down where the board is.
constexpr std::size_t kMinCorners = 8;
/// Residuals below this are good, whatever the other views have.
constexpr double kGoodRmsPx = 0.1;
/// A fit that already leaves views out is repeated so often at most.
constexpr int kMaxRounds = 4;

struct Pair {
    std::optional<Error> error;
    ImageSize size;
    BoardView left;
    BoardView right;
};

Pair read_pair(const fs::path& left, const fs::path& right, const CalibrationBoard& board) {
    Pair pair;
    const Result<cv::Mat> left_image = load_grey_image(left);
    const Result<cv::Mat> right_image = load_grey_image(right);
    if (!left_image || !right_image) {
        pair.error = left_image ? right_image.error() : left_image.error();
        return pair;
    }
    pair.size = {left_image->cols, left_image->rows};
    if (left_image->size() != right_image->size()) {
        pair.error =
            Error{ErrorKind::kInput, fmt::format("{} is {} x {} px, {} is {} x {}", left.string(),
                                                 left_image->cols, left_image->rows, right.string(),
                                                 right_image->cols, right_image->rows)};
        return pair;
    }
    pair.left = find_board(*left_image, board);
    pair.right = in_order_of(pair.left, find_board(*right_image, board), board);
    return pair;
}

CornerPairs common_corners(const Pair& pair, const std::vector<cv::Point3f>& board_m) {
    CornerPairs common;
    for (std::size_t i = 0; i < pair.left.number.size(); ++i) {
        const auto& numbers = pair.right.number;
        const auto at = std::find(numbers.begin(), numbers.end(), pair.left.number[i]);
        if (at == numbers.end()) continue;
        common.board_m.push_back(board_m[static_cast<std::size_t>(pair.left.number[i])]);
        common.left_px.push_back(pair.left.corner_px[i]);
        common.right_px.push_back(
            pair.right.corner_px[static_cast<std::size_t>(at - numbers.begin())]);
    }
    return common;
}

std::string why_unusable(const Pair& pair, std::size_t common) {
    if (pair.left.number.empty() && pair.right.number.empty()) return "no board found in either";
    if (pair.left.number.empty()) return "no board found in the left image";
    if (pair.right.number.empty()) return "no board found in the right image";
    if (common < kMinCorners) return fmt::format("only {} corners in both images", common);
    return {};
}

/// The views that are used now, by index.
struct Selection {
    std::vector<std::size_t> index;
    std::vector<CornerPairs> corners;
};

Selection selected(const std::vector<CalibrationView>& views,
                   const std::vector<CornerPairs>& corners) {
    Selection selection;
    for (std::size_t i = 0; i < views.size(); ++i) {
        if (!views[i].used) continue;
        selection.index.push_back(i);
        selection.corners.push_back(corners[i]);
    }
    return selection;
}

double worse(const CalibrationView& view) {
    return std::max(view.rms_left_px, view.rms_right_px);
}

/// Marks views far above the median; true if there were any.
bool leave_out_outliers(std::vector<CalibrationView>& views, const Selection& selection,
                        const CalibrationSettings& settings) {
    std::vector<double> residuals;
    for (const std::size_t i : selection.index) residuals.push_back(worse(views[i]));
    const auto middle = residuals.begin() + static_cast<std::ptrdiff_t>(residuals.size() / 2);
    std::nth_element(residuals.begin(), middle, residuals.end());
    const double limit = std::max(settings.outlier_factor * *middle, kGoodRmsPx);
    bool any = false;
    for (const std::size_t i : selection.index) {
        if (worse(views[i]) <= limit) continue;
        views[i].used = false;
        views[i].problem = fmt::format("residual {:.2f} px, {:.1f} times the median of the views",
                                       worse(views[i]), worse(views[i]) / *middle);
        any = true;
    }
    return any;
}

/// Lengths of the board's rows and columns, first to last corner, where all of it is seen.
void measure_lengths(const StereoRig& rig, const Selection& selection, std::size_t all_corners,
                     CalibrationResult& result) {
    std::vector<double> errors;
    for (const CornerPairs& view : selection.corners) {
        if (view.board_m.size() != all_corners) continue;
        const std::vector<cv::Point3d> points = triangulate_corners(rig, view);
        const cv::Point3f last = view.board_m.back();
        for (std::size_t a = 0; a < points.size(); ++a) {
            for (std::size_t b = a + 1; b < points.size(); ++b) {
                const cv::Point3f& p = view.board_m[a];
                const cv::Point3f& q = view.board_m[b];
                const bool row = p.y == q.y && p.x == 0.0F && q.x == last.x;
                const bool column = p.x == q.x && p.y == 0.0F && q.y == last.y;
                if (row || column)
                    errors.push_back(cv::norm(points[a] - points[b]) - cv::norm(p - q));
            }
        }
    }
    if (errors.size() < 2) return;
    const double n = static_cast<double>(errors.size());
    double sum = 0.0, squares = 0.0;
    for (const double e : errors) sum += e;
    for (const double e : errors) squares += (e - sum / n) * (e - sum / n);
    result.length_mean_error_m = sum / n;
    result.length_sd_m = std::sqrt(squares / (n - 1.0));
}

void judge(const CalibrationSettings& settings, CalibrationResult& result) {
    if (const Status status = validate(result.rig); !status) {
        result.reason = status.error().message;
    } else if (result.rms_px > settings.max_rms_px) {
        result.reason = fmt::format("reprojection {:.2f} px RMS is over the limit of {:.2f}",
                                    result.rms_px, settings.max_rms_px);
    } else if (result.row_rms_px > settings.max_row_rms_px) {
        result.reason = fmt::format("row error {:.2f} px RMS is over the limit of {:.2f}",
                                    result.row_rms_px, settings.max_row_rms_px);
    }
    result.rejected = !result.reason.empty();
}

Status enough(const Selection& selection, const std::vector<CalibrationView>& views,
              const CalibrationSettings& settings) {
    if (static_cast<int>(selection.index.size()) >= settings.min_views) return {};
    std::string unused;
    for (const CalibrationView& view : views) {
        if (view.used) continue;
        unused += fmt::format("; {}: {}", view.left.filename().string(), view.problem);
    }
    return input_error("{} of {} pairs show the board well enough, at least {} are needed{}",
                       selection.index.size(), views.size(), settings.min_views, unused);
}

/// Fits, leaves out what does not fit the rest, and fits again.
Result<StereoFit> robust_fit(std::vector<CalibrationView>& views,
                             const std::vector<CornerPairs>& corners, ImageSize image,
                             const CalibrationSettings& settings, const Progress& progress) {
    for (int round = 1;; ++round) {
        if (progress.cancelled()) return cancelled_error();
        const Selection selection = selected(views, corners);
        if (const Status s = enough(selection, views, settings); !s)
            return forward_error(s.error());
        Result<StereoFit> fit = fit_stereo(selection.corners, image);
        if (!fit) return fit;
        for (std::size_t k = 0; k < selection.index.size(); ++k) {
            views[selection.index[k]].rms_left_px = fit->rms_left_px[k];
            views[selection.index[k]].rms_right_px = fit->rms_right_px[k];
        }
        if (fit->tilt_deg < settings.min_tilt_deg) {
            return input_error(
                "the board is held the same way in all views (within {:.1f} deg): "
                "tilt it by 20 to 40 deg in several directions",
                fit->tilt_deg);
        }
        if (round == kMaxRounds || !leave_out_outliers(views, selection, settings)) return fit;
    }
}

struct Views {
    ImageSize image;
    std::vector<CalibrationView> views;
    std::vector<CornerPairs> corners;
};

/// Reads all pairs; an image that cannot be read or has another size is an error.
Result<Views> read_views(const std::vector<fs::path>& lefts, const std::vector<fs::path>& rights,
                         const CalibrationBoard& board, const Progress& progress,
                         const ForEach& for_each) {
    std::vector<Pair> pairs(lefts.size());
    for_each(lefts.size(), [&](std::size_t i) {
        if (!progress.cancelled()) pairs[i] = read_pair(lefts[i], rights[i], board);
        progress.tell("find board", i + 1, lefts.size());
    });
    if (progress.cancelled()) return cancelled_error();
    const std::vector<cv::Point3f> board_m = board_points_m(board);
    Views all;
    for (std::size_t i = 0; i < pairs.size(); ++i) {
        if (pairs[i].error) return forward_error(*pairs[i].error);
        if (i == 0) all.image = pairs[i].size;
        if (!(pairs[i].size == all.image)) {
            return input_error("{} is {} x {} px, the first image {} x {}", lefts[i].string(),
                               pairs[i].size.width, pairs[i].size.height, all.image.width,
                               all.image.height);
        }
        all.corners.push_back(common_corners(pairs[i], board_m));
        CalibrationView view;
        view.left = lefts[i];
        view.right = rights[i];
        view.corners = static_cast<int>(all.corners[i].board_m.size());
        view.problem = why_unusable(pairs[i], all.corners[i].board_m.size());
        view.used = view.problem.empty();
        all.views.push_back(view);
    }
    return all;
}

void measure_rows(const StereoRig& rig, const Selection& selection, CalibrationResult& result) {
    double squares = 0.0;
    const std::vector<double> rows = row_errors_px(rig, selection.corners);
    for (const double e : rows) {
        squares += e * e;
        result.row_max_px = std::max(result.row_max_px, std::abs(e));
    }
    result.row_rms_px = std::sqrt(squares / static_cast<double>(rows.size()));
}

}  // namespace

Result<CalibrationResult> calibrate_stereo(const std::vector<fs::path>& lefts,
                                           const std::vector<fs::path>& rights,
                                           const CalibrationBoard& board,
                                           const CalibrationSettings& settings,
                                           const Progress& progress, const ForEach& for_each) {
    if (const Status s = validate(board); !s) return forward_error(s.error());
    if (lefts.size() != rights.size()) {
        return input_error("{} left and {} right images: the lists must pair up", lefts.size(),
                           rights.size());
    }
    Result<Views> all = read_views(lefts, rights, board, progress, for_each);
    if (!all) return forward_error(all.error());
    const auto fit = robust_fit(all->views, all->corners, all->image, settings, progress);
    if (!fit) return forward_error(fit.error());
    CalibrationResult result;
    result.rig = fit->rig;
    result.distortion_model = fit->distortion_model;
    result.rms_px = fit->rms_px;
    const Selection selection = selected(all->views, all->corners);
    measure_rows(fit->rig, selection, result);
    measure_lengths(fit->rig, selection, board_points_m(board).size(), result);
    result.views = std::move(all->views);
    judge(settings, result);
    return result;
}

}  // namespace gripscan
