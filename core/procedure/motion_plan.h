// The way to an angle of joint 6: in pieces of an allowed length, and always arriving upwards, so
// that the play of the gears lies on the same side in every view.
#pragma once

#include <vector>

namespace gripscan {

struct MotionLimits {
    double approach_rad = 0.0;      ///< a target below is passed by so much first
    double largest_move_rad = 0.0;  ///< of one piece, > 0
    double least_joint6_rad = 0.0;  ///< end of the joint's range
};

/// Angles to drive to, in order, the last one being the target. Nothing if the joint stands there.
[[nodiscard]] std::vector<double> way_to(double target_rad, double from_rad,
                                         const MotionLimits& limits);

/// A standing joint is at an angle if it reads it to this (controller's own tolerance, and play of
/// the encoder).
[[nodiscard]] bool stands_at(double reading_rad, double angle_rad);

}  // namespace gripscan
