// Calibrates a stereo rig from images of a board: finds the corners, chooses the distortion model
// by evidence, leaves out images that do not fit the others (naming them), and says how good the
// rig is: reprojection, row error after rectification, board lengths measured with it.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/base/for_each.h"
#include "core/base/progress.h"
#include "core/geometry/stereo_rig.h"
#include "core/stereo/calibration_board.h"

namespace gripscan {

struct CalibrationSettings {
    double max_rms_px = 0.5;      ///< a rig above is rejected: reprojection …
    double max_row_rms_px = 0.5;  ///< … or rows
    double outlier_factor = 3.0;  ///< views with this many times the median residual are left out
    int min_views = 5;
    double min_tilt_deg = 8.0;  ///< between the board's directions, else f cannot be known
};

/// What became of a pair of images.
struct CalibrationView {
    std::filesystem::path left;
    std::filesystem::path right;
    int corners = 0;  ///< seen in both
    bool used = false;
    std::string problem;       ///< why it is not used
    double rms_left_px = 0.0;  ///< reprojection in the final rig; 0 where no board was found
    double rms_right_px = 0.0;
};

struct CalibrationResult {
    StereoRig rig;
    std::vector<CalibrationView> views;  ///< in the order given
    std::string distortion_model;        ///< in words
    double rms_px = 0.0;                 ///< reprojection, both cameras, used views
    double row_rms_px = 0.0;             ///< row difference of the corners after rectification
    double row_max_px = 0.0;
    /// Sides of the board measured by triangulation against the board: mean and standard deviation.
    double length_mean_error_m = 0.0;
    double length_sd_m = 0.0;
    bool rejected = false;  ///< over a limit: to be written only on demand
    std::string reason;     ///< of the rejection
};

/// Pairs lefts[i] with rights[i]. Errors: unequal counts, an unreadable image (named), images of
/// different sizes, too few views with a board, boards that are all parallel, cancelled.
[[nodiscard]] Result<CalibrationResult> calibrate_stereo(
    const std::vector<std::filesystem::path>& lefts,
    const std::vector<std::filesystem::path>& rights, const CalibrationBoard& board,
    const CalibrationSettings& settings, const Progress& progress, const ForEach& for_each);

}  // namespace gripscan
