#include "core/sim/motion_profile.h"

#include <algorithm>
#include <cmath>

namespace gripscan::sim {

double MotionProfile::top_speed_rad_s() const {
    return std::min(speed_rad_s, std::sqrt(std::abs(to_rad - from_rad) * acceleration_rad_s2));
}

double MotionProfile::duration_s() const {
    const double top = top_speed_rad_s();
    if (top == 0.0) return 0.0;
    return std::abs(to_rad - from_rad) / top + top / acceleration_rad_s2;
}

double MotionProfile::position_rad(double t_s) const {
    const double end_s = duration_s();
    if (t_s <= 0.0) return from_rad;
    if (t_s >= end_s) return to_rad;
    const double top = top_speed_rad_s();
    const double ramp_s = top / acceleration_rad_s2;
    const double way = std::abs(to_rad - from_rad);
    const auto speeding_up = [&](double t) { return acceleration_rad_s2 * t * t / 2.0; };
    double gone = top * (t_s - ramp_s / 2.0);
    if (t_s < ramp_s) gone = speeding_up(t_s);
    if (t_s > end_s - ramp_s) gone = way - speeding_up(end_s - t_s);
    return from_rad + std::copysign(std::clamp(gone, 0.0, way), to_rad - from_rad);
}

}  // namespace gripscan::sim
