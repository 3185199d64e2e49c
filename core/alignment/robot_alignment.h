// The robot-camera alignment from a board: closed-form starts, refined on the reprojection of all
// corners, with its residuals, its uncertainty and a verdict.
#pragma once

#include "core/alignment/board_view.h"
#include "core/alignment/hand_eye.h"
#include "core/base/progress.h"

namespace gripscan {

struct AlignmentView {
    Pose T_robot_flange = Pose::Identity();
    BoardObservation board;
};

struct AlignmentLimits {
    double spread_m = 0.008;    ///< rms of where the views see the board
    double spread_rad = 0.014;  ///< 0.8°
    double sd_m = 0.005;        ///< of the result
};

struct RobotAlignment {
    Mounting mounting = Mounting::kBoardOnFlange;
    HandEyePoses poses;
    std::string start;  ///< the closed-form method that agreed best
    /// On the reprojection of all corners, as if the robot's poses had no error. Where they have
    /// much, that makes the views agree worse, and the closed form stays.
    bool refined = false;
    std::vector<HandEyeCandidate> candidates;
    BoardSpread spread;
    double reprojection_px = 0.0;  ///< rms, with the refined poses and the robot's
    double board_px = 0.0;         ///< rms of the boards by themselves
    double sd_m = 0.0;             ///< of X's position, by leaving out one view after the other
    double sd_rad = 0.0;
    bool rejected = false;
    std::string reason;  ///< of the rejection
};

/// Errors: as check_views(), cancelled.
[[nodiscard]] Result<RobotAlignment> align_robot(std::span<const AlignmentView> views,
                                                 const RectifiedRig& camera, Mounting mounting,
                                                 const AlignmentLimits& limits,
                                                 const Progress& progress);

}  // namespace gripscan
