// The numerical part of a stereo calibration: from corners to a rig.
#pragma once

#include <opencv2/core/mat.hpp>
#include <string>
#include <vector>

#include "core/geometry/stereo_rig.h"

namespace gripscan {

/// Corners of one view that both cameras see.
struct CornerPairs {
    std::vector<cv::Point3f> board_m;
    std::vector<cv::Point2f> left_px;
    std::vector<cv::Point2f> right_px;
};

struct StereoFit {
    StereoRig rig;
    std::string distortion_model;
    double rms_px = 0.0;
    std::vector<double> rms_left_px;  ///< per view
    std::vector<double> rms_right_px;
    double tilt_deg = 0.0;  ///< largest angle between two directions of the board
};

/// Models tried: two radial terms; with tangential ones; with a third radial one. The richer model
/// is taken where it lowers the Bayesian information criterion. Errors: what OpenCV cannot solve.
[[nodiscard]] Result<StereoFit> fit_stereo(const std::vector<CornerPairs>& views, ImageSize image);

/// Row differences of the corners in the rectified images, px, one per corner.
[[nodiscard]] std::vector<double> row_errors_px(const StereoRig& rig,
                                                const std::vector<CornerPairs>& views);

/// Corners by triangulation, m, in the camera frame.
[[nodiscard]] std::vector<cv::Point3d> triangulate_corners(const StereoRig& rig,
                                                           const CornerPairs& view);

}  // namespace gripscan
