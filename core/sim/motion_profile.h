// How one joint travels from angle to angle: speeds up, goes on, slows down.
#pragma once

namespace gripscan::sim {

/// A trapezoid of speed, or a triangle where the way is too short for the full speed. Speed and
/// acceleration are positive; times count from the start of the motion.
struct MotionProfile {
    double from_rad = 0.0;
    double to_rad = 0.0;
    double speed_rad_s = 1.0;
    double acceleration_rad_s2 = 1.0;

    [[nodiscard]] double top_speed_rad_s() const;
    [[nodiscard]] double duration_s() const;
    /// Exactly `from_rad` up to the start and exactly `to_rad` from the end on.
    [[nodiscard]] double position_rad(double t_s) const;
};

}  // namespace gripscan::sim
