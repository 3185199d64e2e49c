// Where the camera stands relative to the robot, from poses of a board that the robot moved or the
// camera was moved before: A · X = Y · C⁻¹ for every view. Poses are T_target_source.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/geometry/pose.h"

namespace gripscan {

enum class Mounting {
    kBoardOnFlange,   ///< the camera stands still: X = T_robot_camera, Y = T_flange_board
    kCameraOnFlange,  ///< the board lies still: X = T_flange_camera, Y = T_robot_board
};

/// One view: what the robot said and what the camera saw.
struct HandEyeView {
    Pose T_robot_flange = Pose::Identity();
    Pose T_camera_board = Pose::Identity();
};

/// X and Y as above.
struct HandEyePoses {
    Pose X = Pose::Identity();
    Pose Y = Pose::Identity();
};

/// The fixed side of a view: A · X · T_camera_board = Y.
[[nodiscard]] inline Pose fixed_side(const HandEyeView& view, Mounting mounting) {
    return mounting == Mounting::kBoardOnFlange ? view.T_robot_flange.inverse()
                                                : view.T_robot_flange;
}

/// By how much the views disagree where the board is (on the flange, or in the robot's base).
struct BoardSpread {
    double rms_m = 0.0;
    double max_m = 0.0;
    double rms_rad = 0.0;
    double max_rad = 0.0;
    /// One number to choose by: a turn counts by what it moves a tenth of a metre away.
    [[nodiscard]] double cost_m() const { return rms_m + 0.1 * rms_rad; }
};
[[nodiscard]] BoardSpread board_spread(std::span<const HandEyeView> views, Mounting mounting,
                                       const HandEyePoses& poses);

/// The mean of A · X · T_camera_board over the views.
[[nodiscard]] Pose mean_board(std::span<const HandEyeView> views, Mounting mounting, const Pose& X);

/// Can these views tell X at all? Fewer than three, hardly any turn, or turns about one axis only
/// (joint 6 alone) leave the shift along that axis and the turn about it unknown: an error that
/// says what to do.
[[nodiscard]] Status check_views(std::span<const HandEyeView> views);

struct HandEyeCandidate {
    std::string method;  ///< "Park", …
    HandEyePoses poses;
    BoardSpread spread;
};

/// Every closed-form method that gave a rigid motion, Park and Martin first. None is trusted by its
/// name: some are wrong by decimetres on views with large turns. Errors: as check_views().
[[nodiscard]] Result<std::vector<HandEyeCandidate>> solve_hand_eye(
    std::span<const HandEyeView> views, Mounting mounting);

/// The one whose views agree best; the first one where none is better by more than a fiftieth.
[[nodiscard]] const HandEyeCandidate& best_of(const std::vector<HandEyeCandidate>& candidates);

}  // namespace gripscan
